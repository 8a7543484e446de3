/* selection.c - see selection.h. */
#include "selection.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

enum { LONGEST_NAME = 63, NEAR = 3 };

static int least(int a, int b) { return a < b ? a : b; }

/* Levenshtein's distance of two names: insertions, deletions and replacements of a character. */
static int edit_distance(const char *a, const char *b) {
  int row[LONGEST_NAME + 1]; /* distances of the part of a read so far from each beginning of b */
  const int length = (int)strlen(b);
  for (int j = 0; j <= length; ++j) row[j] = j;
  for (int i = 1; a[i - 1] != '\0'; ++i) {
    int diagonal = row[0];
    row[0] = i;
    for (int j = 1; j <= length; ++j) {
      const int replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = least(replaced, least(row[j], row[j - 1]) + 1);
    }
  }
  return row[length];
}

static bool is_near(const char *wanted, const char *name) {
  return strstr(name, wanted) != NULL || edit_distance(name, wanted) <= NEAR;
}

/* Which names the user may have meant; all of them when none is near. */
static void complain_unknown(const char *wanted) {
  bool any = false;
  complain("the library has no function '%s'", wanted);
  for (int pass = 0; pass < 2 && !any; ++pass) {
    fputs(pass == 0 ? "near names:" : " none; all names:", stderr);
    for (int i = 0; i < function_count; ++i) {
      if (pass == 0 && !is_near(wanted, functions[i].name)) continue;
      fprintf(stderr, " %s", functions[i].name);
      any = true;
    }
  }
  fputc('\n', stderr);
}

static bool add_one(struct selection *selection, const char *name, size_t length) {
  char wanted[LONGEST_NAME + 1];
  if (length == 0 || length > LONGEST_NAME) {
    complain("--only expects names of functions parted by commas");
    return false;
  }
  memcpy(wanted, name, length);
  wanted[length] = '\0';
  const struct function *function = find_function(wanted);
  if (function == NULL) {
    complain_unknown(wanted);
    return false;
  }
  selection->chosen[function - functions] = true;
  return true;
}

bool selection_add(struct selection *selection, const char *list) {
  if (selection->chosen == NULL) selection->chosen = calloc((size_t)function_count, sizeof *selection->chosen);
  if (selection->chosen == NULL) {
    complain("not enough memory");
    return false;
  }
  for (;;) {
    const size_t length = strcspn(list, ",");
    if (!add_one(selection, list, length)) return false;
    if (list[length] == '\0') return true;
    list += length + 1;
  }
}

bool selection_has(const struct selection *selection, const struct function *function) {
  return selection->chosen == NULL || selection->chosen[function - functions];
}

void selection_free(struct selection *selection) { free(selection->chosen); }
