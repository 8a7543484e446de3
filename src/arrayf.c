#define CHS_SINGLE
#include "array.c"
