/* methods.c - see methods.h. */
#include "methods.h"

#include <string.h>

const struct method methods[METHODS] = {
    {"angeles", "Angeles", chs_motion_angeles, chs_motion_angelesf},
    {"laub-shiflett", "Laub & Shiflett", chs_motion_laub_shiflett, chs_motion_laub_shiflettf},
    {"spoor-veldpaus", "Spoor & Veldpaus", chs_motion_spoor_veldpaus, chs_motion_spoor_veldpausf},
    {"bottema-roth", "Bottema & Roth", chs_motion_bottema_roth, chs_motion_bottema_rothf},
    {"beggs", "Beggs", chs_motion_beggs, chs_motion_beggsf},
    {"least-squares", "least squares", NULL, NULL},
};

const struct method *find_method(const char *name) {
  for (int i = 0; i < METHODS; ++i) {
    if (strcmp(methods[i].name, name) == 0) return &methods[i];
  }
  return NULL;
}
