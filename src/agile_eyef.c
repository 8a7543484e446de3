#define CHS_SINGLE
#include "agile_eye.c"
