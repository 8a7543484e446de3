/* selection.h - the functions that --only names. */
#ifndef SELECTION_H
#define SELECTION_H

#include <stdbool.h>

#include "functions.h"

struct selection {
  bool *chosen; /* one flag a function of the registry; NULL: all are chosen */
};

/* Adds the functions of a list parted by commas. False, with a message that names near ones, when one is unknown. */
bool selection_add(struct selection *selection, const char *list);
bool selection_has(const struct selection *selection, const struct function *function);
void selection_free(struct selection *selection);

#endif
