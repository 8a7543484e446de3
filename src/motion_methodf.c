#define CHS_SINGLE
#include "motion_method.c"
