#define CHS_SINGLE
#include "screw.c"
