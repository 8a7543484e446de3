/* ik.c - chasles ik: the joint values at which a robot's tool is where it shall be. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "commands.h"
#include "robot.h"
#include "text.h"

const char ik_help[] =
    "usage: chasles ik [options] ROBOT NUMBER...\n"
    "\n"
    "Inverse kinematics: prints joint values, in the units of the file ROBOT and within its limits, at which the tool\n"
    "has the pose of the numbers: twelve, the rows of [R p] as chasles fk prints them; or six, the position x y z and\n"
    "the rotation vector, whose direction is the axis and whose length the angle, in the unit of angles of the file.\n"
    "\n"
    "options, before ROBOT:\n"
    "  --start Q1,Q2,...  joint values to start from, which decide what solution is found (default: the middle of the\n"
    "                     joints' ranges)\n"
    "  --method NAME      newton or damped (default: newton)\n"
    "  --angle X          rotation that may be left, with rad or deg behind it (default: 1e-10rad)\n"
    "  --length X         distance that may be left, in the unit of the file (default: 1e-8)\n"
    "  --steps N          the most steps of a search (default: 100)\n"
    "  --restarts N       how often a search that failed starts again elsewhere (default: 50)\n"
    "  --exact            all digits, and the joint values alone\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  a solution was found\n"
    "  1  none was; the joint values printed are those that come nearest\n"
    "  2  unusable input or arguments\n"
    "\n"
    "examples:\n"
    "  chasles ik tools/robots/ur5e.robot 0.4 -0.2 0.3 0 180 0\n"
    "  chasles ik --start 0,-90,90,0,90,0 tools/robots/ur5e.robot $(chasles fk --exact tools/robots/ur5e.robot 10 -80\n"
    "    70 20 60 5)\n";

struct options {
  const char *start;
  chs_ik ik;
  bool exact;
};

enum { MOST_STEPS = 1000000 };

static bool read_pose(const struct robot *robot, int count, char **words, double T[16]) {
  double numbers[12];
  if (!no_options(count, words)) return false;
  if (count != 6 && count != 12) {
    complain("a pose has 6 or 12 numbers, and %d are given; see 'chasles help ik'", count);
    return false;
  }
  for (int i = 0; i < count; ++i) {
    if (read_number(words[i], &numbers[i])) continue;
    complain("expected a number of a pose, not '%s'", words[i]);
    return false;
  }
  if (count == 12) {
    const double R[9] = {numbers[0], numbers[1], numbers[2], numbers[4], numbers[5],
                         numbers[6], numbers[8], numbers[9], numbers[10]};
    const double p[3] = {numbers[3], numbers[7], numbers[11]};
    chs_se3_from_parts(R, p, T);
    return true;
  }
  double R[9];
  for (int i = 3; i < 6 && robot->degrees; ++i) numbers[i] = in_radians(numbers[i]);
  const int status = chs_so3_exp(numbers + 3, R);
  if (status < 0) complain("%s", chs_status_text(status));
  if (status < 0) return false;
  chs_se3_from_parts(R, numbers, T);
  return true;
}

/* The middle of each range; 0 where it is endless. */
static void start_in_the_middle(const struct robot *robot, double *q) {
  for (int i = 0; i < robot->joints; ++i) {
    const double middle = (robot->limits[2 * i] + robot->limits[2 * i + 1]) / 2.0;
    q[i] = middle - middle == 0.0 ? middle : 0.0;
  }
}

static bool read_start(const struct robot *robot, const char *text, double *q) {
  const int count = read_number_list(text, q, MOST_JOINTS);
  for (int i = 0; i < count && i < robot->joints; ++i) q[i] = robot_value(robot, i, q[i]);
  if (count == robot->joints) return true;
  complain("--start expects %d numbers parted by commas, not '%s'", robot->joints, text);
  return false;
}

static void print_values(const struct robot *robot, const double *q, bool exact) {
  for (int i = 0; i < robot->joints; ++i) {
    if (i > 0) putchar(' ');
    print_value(robot_written(robot, i, q[i]), 0, exact);
  }
  putchar('\n');
}

/* What a status of inverse kinematics says of the robot. */
static const char *outcome(int status) {
  return status == CHS_NEAR_SINGULAR ? "no joint moves the tool nearer, as where it is out of reach"
                                     : chs_status_text(status);
}

static int ik(const struct options *options, const struct robot *robot, const double T[16], double *q) {
  const chs_chain chain = robot_chain(robot);
  double scratch[CHS_CHAIN_IK_SCRATCH(MOST_JOINTS)];
  double residual[2];
  const int status = chs_chain_ik(&chain, T, q, &options->ik, scratch, q, residual);
  if (status < 0) {
    complain("%s", chs_status_text(status));
    return UNUSABLE;
  }
  const char *gap = robot->unit[0] == '\0' ? "" : " ";
  print_values(robot, q, options->exact);
  if (!options->exact) {
    printf("left: %.3g rad, %.3g%s%s: %s\n", residual[0], residual[1], gap, robot->unit, outcome(status));
  } else if (status != CHS_OK) {
    complain("%s: %.3g rad and %.3g%s%s are left", outcome(status), residual[0], residual[1], gap, robot->unit);
  }
  return status == CHS_OK ? ALL_WELL : SOMETHING_OVER;
}

/* ---- Options ---- */

static bool read_method(const char *name, chs_ik *ik) {
  ik->method = strcmp(name, "damped") == 0 ? CHS_IK_DAMPED : CHS_IK_NEWTON;
  if (ik->method == CHS_IK_DAMPED || strcmp(name, "newton") == 0) return true;
  complain("--method expects newton or damped, not '%s'", name);
  return false;
}

static bool read_count(const char *option, const char *word, int *count) {
  long value = 0;
  if (parse_integer(word, 0, MOST_STEPS, &value)) {
    *count = (int)value;
    return true;
  }
  complain("--%s expects a number from 0 to %d, not '%s'", option, (int)MOST_STEPS, word);
  return false;
}

static bool read_angle_option(const char *word, double *angle) {
  if (read_angle(word, angle) && *angle > 0.0) return true;
  complain("--angle expects an angle above 0 with rad or deg behind it, not '%s'", word);
  return false;
}

static bool read_length_option(const char *word, double *length) {
  if (read_number(word, length) && *length > 0.0) return true;
  complain("--length expects a number above 0, not '%s'", word);
  return false;
}

/* Options end at the robot, so that numbers may be negative. Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"start", required_argument, NULL, 's'},
                                        {"method", required_argument, NULL, 'm'},
                                        {"angle", required_argument, NULL, 'a'},
                                        {"length", required_argument, NULL, 'l'},
                                        {"steps", required_argument, NULL, 'n'},
                                        {"restarts", required_argument, NULL, 'r'},
                                        {"exact", no_argument, NULL, 'e'},
                                        {"help", no_argument, NULL, 'h'},
                                        {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, "+:h", names, NULL)) != -1) {
    switch (option) {
    case 's': options->start = optarg; break;
    case 'm': good = read_method(optarg, &options->ik); break;
    case 'a': good = read_angle_option(optarg, &options->ik.angle); break;
    case 'l': good = read_length_option(optarg, &options->ik.length); break;
    case 'n': good = read_count("steps", optarg, &options->ik.steps); break;
    case 'r': good = read_count("restarts", optarg, &options->ik.restarts); break;
    case 'e': options->exact = true; break;
    case 'h': fputs(ik_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (!good) return UNUSABLE;
  if (optind < argc) return -1;
  complain("ik expects the file of a robot; see 'chasles help ik'");
  return UNUSABLE;
}

int ik_command(int argc, char **argv) {
  struct options options = {NULL, {CHS_IK_NEWTON, 1e-10, 1e-8, 0.1, 100, 50}, false};
  struct robot robot;
  double q[MOST_JOINTS];
  double T[16];
  const int status = read_options(argc, argv, &options);
  if (status != -1) return status;
  if (!robot_read(&robot, argv[optind])) return UNUSABLE;
  if (!read_pose(&robot, argc - optind - 1, argv + optind + 1, T)) return UNUSABLE;
  if (options.start == NULL) {
    start_in_the_middle(&robot, q);
  } else if (!read_start(&robot, options.start, q)) {
    return UNUSABLE;
  }
  return ik(&options, &robot, T, q);
}
