#include <limits.h>
#include <string.h>

#include "support/suite.h"

static const int statuses[] = {
    CHS_OK,
    CHS_HALF_TURN,
    CHS_PURE_TRANSLATION,
    CHS_NO_MOTION,
    CHS_ILL_CONDITIONED,
    CHS_ERR_NAN,
    CHS_AZIMUTH_UNDEFINED,
    CHS_TORSION_UNDEFINED,
    CHS_ERR_INFINITE,
    CHS_ERR_OVERFLOW,
    CHS_ERR_SINGULAR,
    CHS_ERR_ANGLE_RANGE,
    CHS_ERR_NOT_ROTATION,
    CHS_ERR_REFLECTION,
    CHS_ERR_COINCIDENT,
    CHS_ERR_COLLINEAR,
    CHS_ERR_NOT_RIGID,
    CHS_POINTS_MISSING,
    CHS_PARALLEL,
    CHS_COINCIDENT,
    CHS_INTERSECTING,
    CHS_ITERATION_LIMIT,
    CHS_AT_JOINT_LIMIT,
    CHS_NEAR_SINGULAR,
    CHS_SELF_MOTION,
    CHS_ERR_ARGUMENT,
    CHS_ERR_TOO_FEW_POINTS,
    CHS_ERR_LOCKUP,
};
static const int others[] = {CHS_SELF_MOTION + 1, CHS_ERR_LOCKUP - 1, 100, INT_MAX, INT_MIN};

static void assert_reads_well(int status) {
  const char *text = chs_status_text(status);
  TEST_ASSERT_NOT_NULL(text);
  size_t length = strlen(text);
  TEST_ASSERT_GREATER_THAN(0, length);
  TEST_ASSERT_TRUE_MESSAGE(text[length - 1] != '.', text);
}

static void test_the_list_of_this_test_is_complete(void) {
  int sum = 0;
  for (int k = 0; k < LENGTH(statuses); k++) sum += statuses[k];
  TEST_ASSERT_EQUAL_INT(CHS_SELF_MOTION - CHS_ERR_LOCKUP + 1, LENGTH(statuses));
  TEST_ASSERT_EQUAL_INT(14 * 15 / 2 - 13 * 14 / 2, sum);
}

static void test_every_status_has_a_text_without_a_full_stop(void) {
  for (int k = 0; k < LENGTH(statuses); k++) assert_reads_well(statuses[k]);
}

static void test_no_two_statuses_have_the_same_text(void) {
  for (int k = 0; k < LENGTH(statuses); k++)
    for (int m = 0; m < k; m++)
      TEST_ASSERT_TRUE(strcmp(chs_status_text(statuses[k]), chs_status_text(statuses[m])) != 0);
}

static void test_any_other_number_has_a_text_of_its_own(void) {
  for (int k = 0; k < LENGTH(others); k++) {
    assert_reads_well(others[k]);
    for (int m = 0; m < LENGTH(statuses); m++)
      TEST_ASSERT_TRUE(strcmp(chs_status_text(others[k]), chs_status_text(statuses[m])) != 0);
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_the_list_of_this_test_is_complete);
  RUN_TEST(test_every_status_has_a_text_without_a_full_stop);
  RUN_TEST(test_no_two_statuses_have_the_same_text);
  RUN_TEST(test_any_other_number_has_a_text_of_its_own);
  return SUITE_END();
}
