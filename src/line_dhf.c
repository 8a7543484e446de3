#define CHS_SINGLE
#include "line_dh.c"
