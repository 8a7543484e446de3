#define CHS_SINGLE
#include "algebra.c"
