// The same program in C++: the headers must compile there, and the C library must link.
#include "main.c"
