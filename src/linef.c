#define CHS_SINGLE
#include "line.c"
