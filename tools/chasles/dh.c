/* dh.c - chasles dh: a robot told in another way. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <math.h>
#include <string.h>

#include "angles.h"
#include "commands.h"
#include "robot.h"
#include "text.h"

const char dh_help[] =
    "usage: chasles dh [options] ROBOT\n"
    "\n"
    "Prints the robot of a file as a file, with rows of Denavit and Hartenberg's parameters in either convention, or\n"
    "of screws: each of the three ways from any other. The poses at equal joint values are the same.\n"
    "\n"
    "options:\n"
    "  --rows KIND        dh-standard, dh-modified or screws (default: dh-standard)\n"
    "  --tolerance X      sine of the angle below which two axes count as parallel, and distance as a part of the\n"
    "                     robot's size below which they count as meeting (default: 1e-9)\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  the robot was printed\n"
    "  2  unusable input or arguments\n"
    "\n"
    "examples:\n"
    "  chasles dh tools/robots/scara.robot\n"
    "  chasles dh --rows dh-modified tools/robots/ur5e.robot >ur5e-craig.robot\n"
    "  chasles dh --rows screws tools/robots/puma560.robot\n";

static const char *const kinds[] = {"screws", "dh-standard", "dh-modified"};

struct options {
  int rows; /* of kinds */
  double tolerance;
};

static void print_number(double x) {
  putchar(' ');
  print_shortest(stdout, x + 0.0); /* no negative zeros */
}

static void print_numbers(const double *x, int count) {
  for (int i = 0; i < count; ++i) print_number(x[i]);
}

static void print_limits(const struct robot *robot, int joint) {
  const double *limits = robot->limits + 2 * joint;
  if (!isinf(limits[0]) && !isinf(limits[1])) {
    fputs("  limits", stdout);
    for (int i = 0; i < 2; ++i) print_number(robot_written(robot, joint, limits[i]));
  }
  putchar('\n');
}

static void print_heading(const struct robot *robot, int rows) {
  printf("robot %s\nangles %s\n", robot->name, robot->degrees ? "degrees" : "radians");
  if (robot->unit[0] != '\0') printf("lengths %s\n", robot->unit);
  printf("rows %s\n", kinds[rows]);
}

static void print_pose_line(const char *name, const double T[16]) {
  fputs(name, stdout);
  print_numbers(T, 12);
  putchar('\n');
}

static int failed(int status) {
  complain("%s", chs_status_text(status));
  return UNUSABLE;
}

static int print_screws(const struct robot *robot) {
  print_heading(robot, 0);
  for (int i = 0; i < robot->joints; ++i) {
    double q[3];
    double s[3];
    double h = 0.0;
    const int status = chs_screw_axis_parts(robot->screws + 6 * i, q, s, &h);
    if (status < 0) return failed(status);
    fputs(!robot->turns[i] ? "prismatic" : robot->pitch[i] != 0.0 ? "helical" : "revolute", stdout);
    print_numbers(s, 3);
    if (robot->turns[i]) print_numbers(q, 3);
    if (robot->turns[i] && robot->pitch[i] != 0.0) print_number(h);
    print_limits(robot, i);
  }
  print_pose_line("home", robot->home);
  return ALL_WELL;
}

/* A point that a prismatic joint's axis may as well go through: one of the next axis that has a place, or the tool. */
static void point_for(const struct robot *robot, int i, double point[3]) {
  double s[3];
  double h;
  for (int k = 0; k < 3; ++k) point[k] = robot->home[4 * k + 3];
  while (i < robot->joints && !robot->turns[i]) ++i;
  if (i < robot->joints) chs_screw_axis_parts(robot->screws + 6 * i, point, s, &h);
}

/* The axis of joint i as a line. False for a helical joint. */
static bool axis_of(const struct robot *robot, int i, double line[6]) {
  const double *S = robot->screws + 6 * i;
  double point[3];
  if (robot->pitch[i] != 0.0) {
    complain("joint %d of %s is helical, which Denavit and Hartenberg's parameters cannot tell", i + 1, robot->name);
    return false;
  }
  memcpy(line, S, 6 * sizeof *line);
  if (robot->turns[i]) return true;
  point_for(robot, i, point);
  const int status = chs_line_from_direction(point, S + 3, line);
  if (status < 0) complain("%s", chs_status_text(status));
  return status >= 0;
}

static int print_dh(const struct robot *robot, const struct options *options) {
  double axes[6 * MOST_JOINTS];
  double dh[4 * MOST_JOINTS];
  double base[16];
  double tool[16];
  for (int i = 0; i < robot->joints; ++i) {
    if (!axis_of(robot, i, axes + 6 * i)) return UNUSABLE;
  }
  const chs_dh convention = strcmp(kinds[options->rows], "dh-standard") == 0 ? CHS_DH_STANDARD : CHS_DH_MODIFIED;
  const int status = chs_line_to_dh(robot->joints, convention, axes, robot->home, options->tolerance, dh, base, tool);
  if (status < 0) return failed(status);
  print_heading(robot, options->rows);
  puts("# joint a alpha d theta");
  print_pose_line("base", base);
  for (int i = 0; i < robot->joints; ++i) {
    fputs(robot->turns[i] ? "revolute" : "prismatic", stdout);
    for (int k = 0; k < 4; ++k) print_number(k % 2 == 1 && robot->degrees ? in_degrees(dh[4 * i + k]) : dh[4 * i + k]);
    print_limits(robot, i);
  }
  print_pose_line("tool", tool);
  return ALL_WELL;
}

static bool read_rows(const char *word, int *rows) {
  for (*rows = 0; *rows < 3; ++*rows) {
    if (strcmp(word, kinds[*rows]) == 0) return true;
  }
  complain("--rows expects dh-standard, dh-modified or screws, not '%s'", word);
  return false;
}

static bool read_tolerance(const char *word, double *tolerance) {
  if (read_number(word, tolerance) && *tolerance >= 0.0) return true;
  complain("--tolerance expects a number of at least 0, not '%s'", word);
  return false;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"rows", required_argument, NULL, 'r'},
                                        {"tolerance", required_argument, NULL, 't'},
                                        {"help", no_argument, NULL, 'h'},
                                        {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'r': good = read_rows(optarg, &options->rows); break;
    case 't': good = read_tolerance(optarg, &options->tolerance); break;
    case 'h': fputs(dh_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (!good) return UNUSABLE;
  if (optind == argc - 1) return -1;
  complain("dh expects one file of a robot; see 'chasles help dh'");
  return UNUSABLE;
}

int dh_command(int argc, char **argv) {
  struct options options = {1, 1e-9};
  struct robot robot;
  const int status = read_options(argc, argv, &options);
  if (status != -1) return status;
  if (!robot_read(&robot, argv[optind])) return UNUSABLE;
  return options.rows == 0 ? print_screws(&robot) : print_dh(&robot, &options);
}
