/* hollow.c - the library's functions without their contents: what a call costs besides, to be taken off the counts.
 *
 * Weak, so that others may stand in for some of them.
 */
#define FUNCTION(name, ...)                                \
  int chs_##name(void);                                    \
  int chs_##name##f(void);                                 \
  __attribute__((weak)) int chs_##name(void) { return 0; } \
  __attribute__((weak)) int chs_##name##f(void) { return 0; }
#include "functions.def"
