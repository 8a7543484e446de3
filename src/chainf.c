#define CHS_SINGLE
#include "chain.c"
