#define CHS_SINGLE
#include "chain_statics.c"
