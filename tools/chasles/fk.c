/* fk.c - chasles fk: where a robot's tool is, and how it moves. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <string.h>

#include "commands.h"
#include "robot.h"
#include "text.h"

const char fk_help[] =
    "usage: chasles fk [options] ROBOT VALUE...\n"
    "\n"
    "Forward kinematics: prints the pose [R p] of the tool of the robot in the file ROBOT, three rows, for one value\n"
    "a joint, in the units of the file. tools/chasles/robot.h says what such a file looks like, and tools/robots has\n"
    "some.\n"
    "\n"
    "options, before ROBOT:\n"
    "  --links            before it the pose of each link, as moved from where it is at zero\n"
    "  --jacobian FRAME   behind it the Jacobian, six rows: of the twist (omega; v) in the fixed frame (space) or in\n"
    "                     the tool's (body), for rates in radians and lengths; its singular values; and with six\n"
    "                     joints its determinant\n"
    "  --exact            all digits of every number\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  the pose was printed\n"
    "  1  so it was, but a joint is beyond its limits\n"
    "  2  unusable input or arguments\n"
    "\n"
    "examples:\n"
    "  chasles fk tools/robots/ur5e.robot 0 -90 90 0 90 0\n"
    "  chasles fk --jacobian body tools/robots/scara.robot 30 -45 100 0\n";

typedef int jacobian_function(const chs_chain *chain, const double *q, double *J, double *T);

struct options {
  bool links;
  jacobian_function *jacobian;
  bool exact;
};

static int failed(int status) {
  complain("%s", chs_status_text(status));
  return UNUSABLE;
}

static int print_links(const chs_chain *chain, const double *q, bool exact) {
  double D[16 * MOST_JOINTS];
  const int status = chs_chain_links(chain, q, D);
  if (status < 0) return failed(status);
  for (int i = 0; i < chain->joints; ++i) {
    printf("link %d\n", i + 1);
    print_pose(D + 16 * i, exact);
  }
  puts("tool");
  return ALL_WELL;
}

static int print_jacobian(const chs_chain *chain, const double *q, const struct options *options) {
  double J[6 * MOST_JOINTS];
  double scratch[CHS_CHAIN_SCRATCH(MOST_JOINTS)];
  double sigma[6];
  double determinant = 0.0;
  const int n = chain->joints;
  int status = options->jacobian(chain, q, J, NULL);
  if (status < 0) return failed(status);
  puts("jacobian");
  print_matrix(J, 6, n, options->exact);
  status = chs_chain_singular_values(n, J, 1.0, scratch, sigma);
  if (status < 0) return failed(status);
  puts("singular values");
  print_matrix(sigma, 1, n < 6 ? n : 6, options->exact);
  if (n != 6) return ALL_WELL;
  status = chs_chain_determinant(J, &determinant);
  if (status < 0) return failed(status);
  puts("determinant");
  print_matrix(&determinant, 1, 1, options->exact);
  return ALL_WELL;
}

/* How many joints are beyond their limits; tells of each. */
static int check_limits(const struct robot *robot, const double *q) {
  int beyond = 0;
  for (int i = 0; i < robot->joints; ++i) {
    const double least = robot->limits[2 * i];
    const double greatest = robot->limits[2 * i + 1];
    if (q[i] >= least && q[i] <= greatest) continue;
    complain("joint %d is beyond its limits, %.9g to %.9g", i + 1, robot_written(robot, i, least),
             robot_written(robot, i, greatest));
    ++beyond;
  }
  return beyond;
}

static int fk(const struct options *options, const struct robot *robot, const double *q) {
  const chs_chain chain = robot_chain(robot);
  double T[16];
  const int status = chs_chain_fk(&chain, q, T);
  if (status < 0) return failed(status);
  int result = options->links ? print_links(&chain, q, options->exact) : ALL_WELL;
  if (result == ALL_WELL) print_pose(T, options->exact);
  if (result == ALL_WELL && options->jacobian != NULL) result = print_jacobian(&chain, q, options);
  if (result != ALL_WELL) return result;
  return check_limits(robot, q) == 0 ? ALL_WELL : SOMETHING_OVER;
}

static bool read_frame(const char *word, struct options *options) {
  if (strcmp(word, "space") == 0) {
    options->jacobian = chs_chain_space_jacobian;
  } else if (strcmp(word, "body") == 0) {
    options->jacobian = chs_chain_body_jacobian;
  } else {
    complain("--jacobian expects space or body, not '%s'", word);
    return false;
  }
  return true;
}

/* Options end at the robot, so that values may be negative. Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"links", no_argument, NULL, 'l'},
                                        {"jacobian", required_argument, NULL, 'j'},
                                        {"exact", no_argument, NULL, 'e'},
                                        {"help", no_argument, NULL, 'h'},
                                        {NULL, 0, NULL, 0}};
  int option;
  while ((option = getopt_long(argc, argv, "+:h", names, NULL)) != -1) {
    switch (option) {
    case 'l': options->links = true; break;
    case 'j':
      if (read_frame(optarg, options)) break;
      return UNUSABLE;
    case 'e': options->exact = true; break;
    case 'h': fputs(fk_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (optind < argc) return -1;
  complain("fk expects the file of a robot; see 'chasles help fk'");
  return UNUSABLE;
}

int fk_command(int argc, char **argv) {
  struct options options = {false, NULL, false};
  struct robot robot;
  double q[MOST_JOINTS];
  const int status = read_options(argc, argv, &options);
  if (status != -1) return status;
  if (!robot_read(&robot, argv[optind])) return UNUSABLE;
  if (!robot_values(&robot, argc - optind - 1, argv + optind + 1, q)) return UNUSABLE;
  return fk(&options, &robot, q);
}
