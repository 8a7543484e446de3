/* hollow.c - the library's functions without their contents: what a call costs besides, to be taken off the counts. It
 * stands before the library when the program is linked, and the first definition counts.
 */
#define FUNCTION(name, ...)          \
  int chs_##name(void);              \
  int chs_##name##f(void);           \
  int chs_##name(void) { return 0; } \
  int chs_##name##f(void) { return 0; }
#include "functions.def"

/* What the registry's calls use besides. */
FUNCTION(motion_begin, )
FUNCTION(motion_add, )
FUNCTION(line_from_dh, )
FUNCTION(line_to_dh, )
