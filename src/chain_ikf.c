#define CHS_SINGLE
#include "chain_ik.c"
