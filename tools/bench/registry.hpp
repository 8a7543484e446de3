/* registry.hpp - the host program's registry, vector reader and error measure, for C++. */
#ifndef REGISTRY_HPP
#define REGISTRY_HPP

extern "C" {
#include "evaluate.h"
#include "functions.h"
#include "tally.h"
#include "vectors.h"
}

#endif
