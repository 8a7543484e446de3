#define CHS_SINGLE
#include "tilt.c"
