#define CHS_SINGLE
#include "rotation.c"
