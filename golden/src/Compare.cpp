#include <golden/Compare.h>
