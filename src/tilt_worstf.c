#define CHS_SINGLE
#include "tilt_worst.c"
