#define CHS_SINGLE
#include "so3.c"
