/* All a test file needs, and Unity's two hooks. */
#ifndef CHASLES_TESTS_SUITE_H
#define CHASLES_TESTS_SUITE_H

#include "algebra.h"
#include "assertions.h"
#include "contract.h"
#include "exact.h"
#include "precision.h"
#include "random.h"

void setUp(void) {
  subject = "";
  restart_random();
}

void tearDown(void) {}

#define SUITE_BEGIN() \
  UNITY_BEGIN();      \
  print_seed()
#define SUITE_END() UNITY_END()

#endif
