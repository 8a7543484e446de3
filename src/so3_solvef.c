#define CHS_SINGLE
#include "so3_solve.c"
