/* paths.h - the vector files that the arguments of `chasles compare` stand for. */
#ifndef PATHS_H
#define PATHS_H

#include <stdbool.h>

struct paths {
  char **names;
  int count;
  int space;
  bool has_directory; /* one was among the arguments */
};

/* Adds a file, or all files of a directory that end in .f64.txt or .f32.txt. False with a message when there is
 * none. */
bool paths_add(struct paths *paths, const char *file_or_directory);

/* Sorts the names, so that the order of a directory does not matter, and leaves out repeated ones. */
void paths_sort(struct paths *paths);

void paths_free(struct paths *paths);

#endif
