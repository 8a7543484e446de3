#define CHS_SINGLE
#include "angle.c"
