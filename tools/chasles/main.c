/* main.c - the program `chasles`: finds the subcommand and runs it. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <string.h>

#include "commands.h"
#include "text.h"

static const char help[] =
    "usage: chasles SUBCOMMAND [options] [arguments]\n"
    "\n"
    "The host program of chasles, a library for finite rigid-body motion.\n"
    "\n"
    "subcommands:\n"
    "  compare DIR_OR_FILE...  compare the library with reference vectors and print the errors\n"
    "  solve FILE.csv          find the screw motion of a body from measured markers\n"
    "  study                   compare the methods for three points as Fenton & Shi 1990 did\n"
    "  fk ROBOT VALUE...       forward kinematics: the pose of a robot's tool, its links, its Jacobian\n"
    "  ik ROBOT NUMBER...      inverse kinematics: the joint values at which the tool has a pose\n"
    "  dh ROBOT                tell a robot by Denavit and Hartenberg's parameters, or by screws\n"
    "  agile-eye               map the rotational errors of the Agile Eye over its orientations\n"
    "  arm-error ROBOT [q...]  find how wrong an arm's tool can be when its joints are\n"
    "  hash                    print one hash of the bits of all results over a large set of inputs\n"
    "  help [SUBCOMMAND]       print this help, or that of a subcommand\n"
    "\n"
    "options:\n"
    "  --help                  print this help\n"
    "  --version               print the version\n"
    "\n"
    "exit status: 0 all well, 1 something found wrong, 2 unusable input or arguments\n"
    "\n"
    "examples:\n"
    "  chasles compare tests/vectors\n"
    "  chasles solve --markers Arm1,Arm2,Arm3 --against previous trial.csv\n";

struct command {
  const char *name;
  int (*run)(int argc, char **argv);
  const char *help;
};

static const struct command commands[] = {
    {"compare", compare_command, compare_help},
    {"solve", solve_command, solve_help},
    {"study", study_command, study_help},
    {"fk", fk_command, fk_help},
    {"ik", ik_command, ik_help},
    {"dh", dh_command, dh_help},
    {"agile-eye", agile_eye_command, agile_eye_help},
    {"arm-error", arm_error_command, arm_error_help},
    {"hash", hash_command, hash_help},
};

static const struct command *find_command(const char *name) {
  for (size_t i = 0; i < sizeof commands / sizeof commands[0]; ++i) {
    if (strcmp(commands[i].name, name) == 0) return &commands[i];
  }
  return NULL;
}

static int unknown_command(const char *name) {
  complain("'%s' is not a subcommand; see 'chasles --help'", name);
  return UNUSABLE;
}

int bad_option(int option, char **argv) {
  const char *given = argv[optind - 1];
  if (option == ':') {
    complain("option '%s' expects a value; see 'chasles help %s'", given, argv[0]);
  } else if (optopt != 0 && given[0] == '-' && given[1] == '-') {
    complain("option '%s' takes no value; see 'chasles help %s'", given, argv[0]);
  } else if (optopt != 0) {
    complain("unknown option '-%c'; see 'chasles help %s'", optopt, argv[0]);
  } else {
    complain("unknown or ambiguous option '%s'; see 'chasles help %s'", given, argv[0]);
  }
  return UNUSABLE;
}

/* Nothing that was typed goes unheard. */
static bool is_too_many(int argc, char **argv, int most) {
  if (argc <= most) return false;
  complain("%s takes no argument '%s'; see 'chasles --help'", argv[0], argv[most]);
  return true;
}

static int print_help(int argc, char **argv) {
  if (is_too_many(argc, argv, 2)) return UNUSABLE;
  const struct command *command = argc > 1 ? find_command(argv[1]) : NULL;
  if (argc > 1 && command == NULL) return unknown_command(argv[1]);
  fputs(command == NULL ? help : command->help, stdout);
  return ALL_WELL;
}

static int run(int argc, char **argv) {
  if (argc < 2) {
    complain("no subcommand given; see 'chasles --help'");
    return UNUSABLE;
  }
  const char *name = argv[1];
  if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
    return print_help(argc - 1, argv + 1);
  }
  if (strcmp(name, "--version") == 0) {
    if (is_too_many(argc - 1, argv + 1, 1)) return UNUSABLE;
    puts("chasles " CHS_VERSION);
    return ALL_WELL;
  }
  if (name[0] == '-') {
    complain("unknown option '%s'; see 'chasles --help'", name);
    return UNUSABLE;
  }
  const struct command *command = find_command(name);
  return command == NULL ? unknown_command(name) : command->run(argc - 1, argv + 1);
}

/* No locale is set: numbers are read and written with a decimal point everywhere. */
int main(int argc, char **argv) {
  opterr = 0;
  const int status = run(argc, argv);
  return output_close(stdout, "standard output") ? status : UNUSABLE;
}
