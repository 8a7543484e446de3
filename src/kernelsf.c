#define CHS_SINGLE
#include "kernels.c"
