/* What the library must not do, for check_objects.py to find. */
#include <math.h>
#include <stdlib.h>

int chs_counter = 3;

float chs_transcendentalf(float x);
void *chs_allocatef(void);
float chs_doublef(float x);
int chs_recursive(int n);
int visible(void);

float chs_transcendentalf(float x) { return sinf(x); }
void *chs_allocatef(void) { return malloc((size_t)chs_counter++); }
float chs_doublef(float x) { return (float)((double)x * 1.1); }
int chs_recursive(int n) { return n < 2 ? n : chs_recursive(n - 1) * chs_recursive(n - 2) + 1; }
int visible(void) { return 1; }
