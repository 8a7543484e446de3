/* The functions of the private headers, for every source compiled for size: see SHARED in real.h. */
#define DEFINE_SHARED
#include "chain_private.h"
#include "cofactors.h"
#include "line_private.h"
#include "motion_private.h"
#include "tilt_private.h"
