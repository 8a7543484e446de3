#define CHS_SINGLE
#include "motion.c"
