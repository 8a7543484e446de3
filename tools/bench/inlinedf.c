#define CHS_SINGLE
#include "inlined.c"
