#define CHS_SINGLE
#include "motion_sums.c"
