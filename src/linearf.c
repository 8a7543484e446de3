#define CHS_SINGLE
#include "linear.c"
