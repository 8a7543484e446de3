#define CHS_SINGLE
#include "motion_points.c"
