#define CHS_SINGLE
#include "se3.c"
