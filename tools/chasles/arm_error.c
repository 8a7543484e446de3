/* arm_error.c - chasles arm-error: how wrong the tool of an arm can be when its joints are. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "commands.h"
#include "robot.h"
#include "sweep.h"
#include "text.h"

const char arm_error_help[] =
    "usage: chasles arm-error [options] ROBOT [--] [q...]\n"
    "\n"
    "How wrong the tool of an arm can be when each of its joints is off by at most epsilon: the largest error alpha of\n"
    "the tool's axis (z), the largest error beta about it, and the largest error of its position. ROBOT is a file as\n"
    "for chasles fk, q the joint values in its units (default: all 0).\n"
    "\n"
    "options:\n"
    "  --epsilon ANGLE    error of a joint that turns, either way, as 0.01deg or 1e-4rad (default: 0.01deg)\n"
    "  --slide LENGTH     error of a joint that slides, in the robot's unit of length (default: 0)\n"
    "  --over I,J         a map: all values of joints I and J, which turn; the others as given\n"
    "  --step DEGREES     step of the map (default: 5)\n"
    "  --grid N           values of each joint on the grid of the error box, its ends among them (default: 2)\n"
    "  --refine N         halvings of the step in the search between grid points (default: 4); 0 for the grid alone\n"
    "  --threads N        (default: one a core)\n"
    "  --out FILE         the map as CSV, '-' for standard output\n"
    "  --help             print this help\n"
    "\n"
    "In CSV, inside says which worst errors (a, b, p for the position) have a joint strictly inside its interval.\n"
    "\n"
    "exit status:\n"
    "  0  the errors were found\n"
    "  1  the arm has none there, or at some place of the map: a status says why\n"
    "  2  unusable input or arguments, or an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles arm-error tools/robots/ur5e.robot -- 0 -90 90 -90 -90 0\n"
    "  chasles arm-error tools/robots/ur5e.robot --over 3,5 --step 2 --out arm.csv -- 0 -90 90 -90 -90 0\n"
    "  python3 tools/study/arm_error.py arm.csv\n";

enum { MEASURES = 3, MOST_SCRATCH = CHS_TILT_WORST_SCRATCH(MOST_JOINTS) };

struct options {
  const char *robot;
  double epsilon;
  double slide;
  long over[2]; /* joints from 1; 0: no map */
  double step;
  long grid;
  long refine;
  long threads;
  const char *out;
};

/* What was found at a configuration. */
struct node {
  double worst[MEASURES]; /* alpha, beta, radians; distance */
  bool inside[MEASURES];  /* whether a joint is strictly inside its interval there */
  int status;
};

struct study {
  const struct options *options;
  struct robot robot;
  chs_chain chain;
  double q[MOST_JOINTS];
  double errors[MOST_JOINTS];
  int steps; /* of the map, each way */
  struct node *nodes;
};

static int pose_of_arm(const double *q, void *chain, double *T) { return chs_chain_fk(chain, q, T); }

/* where: the joint values of each measure's worst. */
static void study_node(struct study *study, const double *q, struct node *node, double *where) {
  const int joints = study->robot.joints;
  double scratch[MOST_SCRATCH];
  for (int m = 0; m < MEASURES; ++m) node->worst[m] = (double)NAN;
  node->status = chs_tilt_worst(pose_of_arm, &study->chain, joints, q, study->errors, (int)study->options->grid,
                                (int)study->options->refine, scratch, node->worst, where);
  for (int m = 0; m < MEASURES; ++m) {
    node->inside[m] = node->status >= 0 && is_inside(joints, q, study->errors, where + m * joints);
  }
}

/* ---- One configuration ---- */

static void print_measure(const struct study *study, const struct node *node, const double *where, int m) {
  static const char *const names[] = {"alpha", "beta", "position"};
  const bool angle = m < 2;
  printf("%-8s %12.6g %-4.15s with joint errors of", names[m], angle ? in_degrees(node->worst[m]) : node->worst[m],
         angle ? "deg" : study->robot.unit);
  for (int i = 0; i < study->robot.joints; ++i) {
    const double off = where[m * study->robot.joints + i] - study->q[i];
    printf(" %+.4g", study->robot.turns[i] ? in_degrees(off) : off);
  }
  putchar('\n');
}

static int print_node(struct study *study) {
  struct node node;
  double where[MEASURES * MOST_JOINTS];
  study_node(study, study->q, &node, where);
  if (node.status < 0) {
    complain("no errors of %s there: %s", study->robot.name, chs_status_text(node.status));
    return SOMETHING_OVER;
  }
  for (int m = 0; m < MEASURES; ++m) print_measure(study, &node, where, m);
  return ALL_WELL;
}

/* ---- A map ---- */

static double map_value(const struct study *study, int step) { return -180.0 + step * study->options->step; }

static void study_row(void *context, long row) {
  struct study *study = context;
  double q[MOST_JOINTS];
  double where[MEASURES * MOST_JOINTS];
  memcpy(q, study->q, sizeof q);
  q[study->options->over[0] - 1] = in_radians(map_value(study, (int)row));
  for (int i = 0; i < study->steps; ++i) {
    q[study->options->over[1] - 1] = in_radians(map_value(study, i));
    study_node(study, q, &study->nodes[row * study->steps + i], where);
  }
}

static void print_map(const struct study *study, FILE *file) {
  const struct node *node = study->nodes;
  const char *unit = study->robot.unit;
  fprintf(file, "q%ld_deg,q%ld_deg,alpha_deg,beta_deg,position%s%s,inside,status\n", study->options->over[0],
          study->options->over[1], *unit == '\0' ? "" : "_", unit);
  for (int i = 0; i < study->steps; ++i) {
    for (int j = 0; j < study->steps; ++j, ++node) {
      fprintf(file, "%g,%g", map_value(study, i), map_value(study, j));
      print_degrees(file, node->worst[0]);
      print_degrees(file, node->worst[1]);
      fputc(',', file);
      if (!isnan(node->worst[2])) fprintf(file, "%.9g", node->worst[2]);
      fputc(',', file);
      for (int m = 0; m < MEASURES; ++m) {
        if (node->inside[m]) fputc("abp"[m], file);
      }
      fprintf(file, ",%d\n", node->status);
    }
  }
}

static long count_good(const struct study *study) {
  long good = 0;
  for (long k = 0; k < (long)study->steps * study->steps; ++k) good += study->nodes[k].status >= 0;
  return good;
}

static void print_extremes(const struct study *study, FILE *file) {
  static const char *const names[] = {"alpha", "beta", "position"};
  const long count = (long)study->steps * study->steps;
  for (int m = 0; m < MEASURES; ++m) {
    double least = (double)INFINITY;
    double most = 0.0;
    for (long k = 0; k < count; ++k) {
      least = fmin(least, study->nodes[k].worst[m]);
      most = fmax(most, study->nodes[k].worst[m]);
    }
    const bool angle = m < 2;
    fprintf(file, "%-8s %12.6g to %12.6g %.15s\n", names[m], angle ? in_degrees(least) : least,
            angle ? in_degrees(most) : most, angle ? "deg" : study->robot.unit);
  }
}

static bool write_map(const struct study *study) {
  const char *name = study->options->out;
  const bool to_stdout = name != NULL && strcmp(name, "-") == 0;
  if (name != NULL) {
    FILE *file = to_stdout ? stdout : output_open(name);
    if (file == NULL) return false;
    print_map(study, file);
    if (!to_stdout && !output_close(file, name)) return false;
  }
  if (count_good(study) > 0) print_extremes(study, to_stdout ? stderr : stdout);
  return true;
}

static int map_errors(struct study *study) {
  study->steps = (int)floor(360.0 / study->options->step + 1e-9) + 1;
  study->nodes = malloc((size_t)study->steps * (size_t)study->steps * sizeof *study->nodes);
  if (study->nodes == NULL) {
    complain("not enough memory for %d x %d configurations", study->steps, study->steps);
    return UNUSABLE;
  }
  int status = UNUSABLE;
  if (sweep(study->steps, (int)study->options->threads, study_row, study) && write_map(study)) {
    const long missing = (long)study->steps * study->steps - count_good(study);
    status = missing == 0 ? ALL_WELL : SOMETHING_OVER;
    if (missing > 0) {
      complain("no errors of %s at %ld of %d x %d configurations", study->robot.name, missing, study->steps,
               study->steps);
    }
  }
  free(study->nodes);
  return status;
}

/* ---- Options ---- */

static bool read_over(const char *word, struct options *options) {
  double joints[2];
  const bool two = read_number_list(word, joints, 2) == 2;
  for (int i = 0; i < 2 && two; ++i) options->over[i] = (long)fmin(fmax(joints[i], 0.0), 1000.0);
  if (two && (double)options->over[0] == joints[0] && (double)options->over[1] == joints[1] && joints[0] >= 1.0 &&
      joints[1] >= 1.0 && joints[0] != joints[1]) {
    return true;
  }
  complain("--over expects the numbers of two joints, from 1, as 3,5, not '%s'", word);
  return false;
}

static bool read_slide(const char *word, struct options *options) {
  if (read_number(word, &options->slide) && options->slide >= 0.0) return true;
  complain("--slide expects a length of at least 0, not '%s'", word);
  return false;
}

/* Returns the exit status when the run ends here, or -1; optind is then at the robot. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {
      {"epsilon", required_argument, NULL, 'e'}, {"slide", required_argument, NULL, 's'},
      {"over", required_argument, NULL, 'v'},    {"step", required_argument, NULL, 'd'},
      {"grid", required_argument, NULL, 'g'},    {"refine", required_argument, NULL, 'r'},
      {"out", required_argument, NULL, 'o'},     {"threads", required_argument, NULL, 't'},
      {"help", no_argument, NULL, 'h'},          {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'e': good = option_epsilon(optarg, &options->epsilon); break;
    case 's': good = read_slide(optarg, options); break;
    case 'v': good = read_over(optarg, options); break;
    case 'd': good = option_degrees("step", optarg, 0.5, 90.0, &options->step); break;
    case 'g': good = option_count("grid", optarg, 2, 101, &options->grid); break;
    case 'r': good = option_count("refine", optarg, 0, 40, &options->refine); break;
    case 't': good = option_count("threads", optarg, 1, MOST_THREADS, &options->threads); break;
    case 'o': options->out = optarg; break;
    case 'h': fputs(arm_error_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (!good) return UNUSABLE;
  if (options->out != NULL && options->over[0] == 0) {
    complain("--out is for maps: it needs --over");
    return UNUSABLE;
  }
  if (optind < argc) {
    options->robot = argv[optind++];
    return -1;
  }
  complain("arm-error expects a robot file; see 'chasles help arm-error'");
  return UNUSABLE;
}

static bool over_is_right(const struct study *study) {
  for (int i = 0; i < 2; ++i) {
    const long joint = study->options->over[i];
    if (joint == 0 || (joint <= study->robot.joints && study->robot.turns[joint - 1])) continue;
    complain("%s has no joint %ld that turns", study->robot.name, joint);
    return false;
  }
  return true;
}

int arm_error_command(int argc, char **argv) {
  struct options options = {NULL, in_radians(0.01), 0.0, {0, 0}, 5.0, 2, 4, core_count(), NULL};
  const int status = read_options(argc, argv, &options);
  if (status != -1) return status;
  struct study study;
  memset(&study, 0, sizeof study);
  study.options = &options;
  if (!robot_read(&study.robot, options.robot)) return UNUSABLE;
  if (optind < argc && !robot_values(&study.robot, argc - optind, argv + optind, study.q)) return UNUSABLE;
  if (!over_is_right(&study)) return UNUSABLE;
  study.chain = robot_chain(&study.robot);
  for (int i = 0; i < study.robot.joints; ++i) {
    study.errors[i] = study.robot.turns[i] ? options.epsilon : options.slide;
  }
  return options.over[0] == 0 ? print_node(&study) : map_errors(&study);
}
