/* scenes.cpp - chasles in the scenes of scenes.def, and its array forms. */
#include "scenes.hpp"

#include <chasles/chasles.h>

#include "library.hpp"

void describe_chasles_scenes(library &library) { (void)library; }
