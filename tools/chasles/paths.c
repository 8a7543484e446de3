/* paths.c - see paths.h. */
#include "paths.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "text.h"

/* Takes over the name, which was allocated and may be NULL for want of memory. */
static bool append(struct paths *paths, char *name) {
  if (name != NULL && paths->count == paths->space) {
    const int space = paths->space == 0 ? 64 : 2 * paths->space;
    char **names = realloc(paths->names, (size_t)space * sizeof *names);
    if (names == NULL) {
      free(name);
      name = NULL;
    } else {
      paths->names = names;
      paths->space = space;
    }
  }
  if (name == NULL) {
    complain("not enough memory for the names of %d files", paths->count + 1);
    return false;
  }
  paths->names[paths->count++] = name;
  return true;
}

static char *join(const char *directory, const char *name) {
  const size_t length = strlen(directory);
  const bool slash = length == 0 || directory[length - 1] != '/';
  const size_t space = length + strlen(name) + 2;
  char *path = malloc(space);
  if (path != NULL) snprintf(path, space, "%s%s%s", directory, slash ? "/" : "", name);
  return path;
}

static bool is_vector_file(const char *name) {
  const size_t length = strlen(name);
  if (length < 8) return false;
  const char *end = name + length - 8;
  return strcmp(end, ".f64.txt") == 0 || strcmp(end, ".f32.txt") == 0;
}

static bool add_directory(struct paths *paths, const char *directory) {
  DIR *stream = opendir(directory);
  if (stream == NULL) {
    complain("cannot read %s: %s", directory, strerror(errno));
    return false;
  }
  const int before = paths->count;
  bool good = true;
  struct dirent *entry = NULL;
  while (good && (entry = readdir(stream)) != NULL) {
    if (is_vector_file(entry->d_name)) good = append(paths, join(directory, entry->d_name));
  }
  closedir(stream);
  if (good && paths->count == before) {
    complain("%s holds no vector file: none of its names ends in .f64.txt or .f32.txt", directory);
    return false;
  }
  return good;
}

bool paths_add(struct paths *paths, const char *file_or_directory) {
  struct stat status;
  if (strcmp(file_or_directory, "-") != 0) {
    if (stat(file_or_directory, &status) != 0) {
      complain("cannot read %s: %s", file_or_directory, strerror(errno));
      return false;
    }
    if (S_ISDIR(status.st_mode)) {
      paths->has_directory = true;
      return add_directory(paths, file_or_directory);
    }
  }
  return append(paths, strdup(file_or_directory));
}

static int compare_names(const void *left, const void *right) {
  return strcmp(*(char *const *)left, *(char *const *)right);
}

void paths_sort(struct paths *paths) {
  if (paths->count == 0) return;
  qsort(paths->names, (size_t)paths->count, sizeof *paths->names, compare_names);
  int kept = 1;
  for (int i = 1; i < paths->count; ++i) {
    if (strcmp(paths->names[i], paths->names[kept - 1]) == 0) {
      free(paths->names[i]);
    } else {
      paths->names[kept++] = paths->names[i];
    }
  }
  paths->count = kept;
}

void paths_free(struct paths *paths) {
  for (int i = 0; i < paths->count; ++i) free(paths->names[i]);
  free(paths->names);
}
