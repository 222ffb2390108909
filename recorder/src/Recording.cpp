#include <recorder/Recording.h>
