#include <render/Renderer.h>
