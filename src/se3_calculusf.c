#define CHS_SINGLE
#include "se3_calculus.c"
