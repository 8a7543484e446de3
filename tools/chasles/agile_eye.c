/* agile_eye.c - chasles agile-eye: the rotational errors of the Agile Eye over its workspace (Briot & Bonev 2008). */
#include <chasles/chasles.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "commands.h"
#include "sweep.h"
#include "text.h"

const char agile_eye_help[] =
    "usage: chasles agile-eye [options]\n"
    "\n"
    "How wrong the orientation of an Agile Eye can be when its motors are: for every direction of the tool, given by\n"
    "azimuth phi and tilt theta, and some torsions sigma, the largest error alpha of the tool's axis and the largest\n"
    "error beta about it, while each joint is off by at most epsilon. The frames are those of chasles/agile_eye.h, in\n"
    "which the reference has tilt 0 and torsion 60 degrees. All working modes have the same errors.\n"
    "\n"
    "options:\n"
    "  --sigma LIST       torsions in degrees, parted by commas; a,b,...,z for a step of b - a\n"
    "                     (default: 0,20,...,120)\n"
    "  --epsilon ANGLE    error of a joint, either way, as 0.01deg or 1e-4rad (default: 0.01deg)\n"
    "  --step DEGREES     step of phi and theta (default: 1)\n"
    "  --tilt DEGREES     largest theta (default: 180)\n"
    "  --grid N           values of each joint on the grid of the error box, its ends among them (default: 3)\n"
    "  --refine N         halvings of the step in the search between grid points (default: 4); 0 for the grid alone\n"
    "  --threads N        (default: one a core)\n"
    "  --out FILE         write CSV, a row for each orientation, '-' for standard output\n"
    "  --curves FILE      write CSV of the six singular curves, '-' for standard output, and do nothing else\n"
    "  --help             print this help\n"
    "\n"
    "In CSV, inside says which worst errors (a, b or ab) have a joint strictly inside its error interval; distance is\n"
    "the turn to the nearest singular orientation; the errors are empty where the error box reaches one. The table\n"
    "gives for each torsion how many orientations are singular in this sense, and what part of the others is inside.\n"
    "\n"
    "exit status:\n"
    "  0  the map or the curves were found\n"
    "  2  unusable arguments, or an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles agile-eye --sigma 0,20,...,120 --epsilon 0.01deg\n"
    "  chasles agile-eye --out errors.csv && chasles agile-eye --curves curves.csv\n"
    "  python3 tools/study/agile_eye.py errors.csv curves.csv\n";

enum { MOST_SIGMAS = 64, MOST_DEGREES = 360 };

struct options {
  double sigmas[MOST_SIGMAS]; /* degrees */
  int sigma_count;
  double epsilon; /* radians */
  double step;    /* degrees */
  double tilt;
  long grid;
  long refine;
  long threads;
  const char *out;
  const char *curves;
};

enum { INSIDE_ALPHA = 1, INSIDE_BETA = 2 };

/* What was found at an orientation; radians. */
struct node {
  double alpha;
  double beta;
  double distance;
  int status;
  int inside;
};

/* All nodes: sigma by sigma, theta by theta, phi by phi. */
struct map {
  const struct options *options;
  int thetas;
  int phis;
  struct node *nodes;
};

/* ---- One orientation ---- */

static int tool_pose(const double *joints, void *assembly, double *T) {
  static const double origin[3] = {0.0, 0.0, 0.0};
  double R[9];
  const int status = chs_agile_eye_direct(joints, *(int *)assembly, R);
  if (status < 0) return status;
  chs_agile_eye_tool(R, R);
  chs_se3_from_parts(R, origin, T);
  return status;
}

/* Of the four orientations of the joints that which is R: its number, which the neighbouring joints share. */
static int assembly_of(const double *joints, const double *R) {
  int nearest = 0;
  double least = 4.0;
  for (int assembly = 0; assembly < 4; ++assembly) {
    double other[9];
    double angle;
    if (chs_agile_eye_direct(joints, assembly, other) < 0) continue;
    if (chs_so3_angle(R, other, &angle) < 0 || angle >= least) continue;
    least = angle;
    nearest = assembly;
  }
  return nearest;
}

static struct node study_node(const struct options *options, double phi, double theta, double sigma) {
  struct node node = {(double)NAN, (double)NAN, (double)NAN, CHS_OK, 0};
  double R[9];
  double joints[3];
  node.status = chs_tilt_to_rotation(in_radians(phi), in_radians(theta), in_radians(sigma), R);
  if (node.status < 0) return node;
  chs_agile_eye_platform(R, R);
  chs_agile_eye_distance(R, &node.distance);
  node.status = chs_agile_eye_inverse(R, 0, joints);
  if (node.status != CHS_OK) return node;

  const double errors[3] = {options->epsilon, options->epsilon, options->epsilon};
  double scratch[CHS_TILT_WORST_SCRATCH(3)];
  double worst[3];
  double where[9];
  int assembly = assembly_of(joints, R);
  node.status = chs_tilt_worst(tool_pose, &assembly, 3, joints, errors, (int)options->grid, (int)options->refine,
                               scratch, worst, where);
  if (node.status < 0) return node;
  node.alpha = worst[0];
  node.beta = worst[1];
  if (is_inside(3, joints, errors, where)) node.inside |= INSIDE_ALPHA;
  if (is_inside(3, joints, errors, where + 3)) node.inside |= INSIDE_BETA;
  return node;
}

/* ---- The map ---- */

/* A row is a sigma and a theta. */
static void study_row(void *context, long row) {
  const struct map *map = context;
  const struct options *options = map->options;
  const double sigma = options->sigmas[row / map->thetas];
  const double theta = (double)(row % map->thetas) * options->step;
  for (int i = 0; i < map->phis; ++i) {
    map->nodes[row * map->phis + i] = study_node(options, i * options->step, theta, sigma);
  }
}

static void print_csv(const struct map *map, FILE *file) {
  static const char *const inside[] = {"", "a", "b", "ab"};
  const struct node *node = map->nodes;
  fputs("sigma_deg,phi_deg,theta_deg,alpha_deg,beta_deg,distance_deg,inside,status\n", file);
  for (int s = 0; s < map->options->sigma_count; ++s) {
    for (int t = 0; t < map->thetas; ++t) {
      for (int p = 0; p < map->phis; ++p, ++node) {
        fprintf(file, "%g,%g,%g", map->options->sigmas[s], p * map->options->step, t * map->options->step);
        print_degrees(file, node->alpha);
        print_degrees(file, node->beta);
        print_degrees(file, node->distance);
        fprintf(file, ",%s,%d\n", inside[node->inside], node->status);
      }
    }
  }
}

static int compare_numbers(const void *a, const void *b) {
  const double x = *(const double *)a;
  const double y = *(const double *)b;
  return (x > y) - (x < y);
}

/* One line a torsion: the least, the middle and the largest of each error, and how many are found inside the box. */
static bool print_summary(const struct map *map, FILE *file) {
  const long count = (long)map->thetas * map->phis;
  double *values = malloc((size_t)count * sizeof *values);
  if (values == NULL) {
    complain("not enough memory for %ld orientations", count);
    return false;
  }
  fprintf(file, "largest errors in degrees for joint errors of %g degrees\n\n", in_degrees(map->options->epsilon));
  fprintf(file, "%9s %8s %8s   %10s %10s %10s %7s   %10s %10s %10s %7s\n", "sigma_deg", "nodes", "singular",
          "alpha_min", "median", "max", "inside", "beta_min", "median", "max", "inside");
  for (int s = 0; s < map->options->sigma_count; ++s) {
    const struct node *nodes = map->nodes + s * count;
    long singular = 0;
    for (long k = 0; k < count; ++k) singular += isnan(nodes[k].alpha);
    fprintf(file, "%9g %8ld %8ld", map->options->sigmas[s], count, singular);
    for (int measure = INSIDE_ALPHA; measure <= INSIDE_BETA; ++measure) {
      long good = 0;
      long inside = 0;
      for (long k = 0; k < count; ++k) {
        if (isnan(nodes[k].alpha)) continue;
        values[good++] = measure == INSIDE_ALPHA ? nodes[k].alpha : nodes[k].beta;
        inside += (nodes[k].inside & measure) != 0;
      }
      if (good == 0) continue;
      qsort(values, (size_t)good, sizeof *values, compare_numbers);
      fprintf(file, "   %10.6f %10.6f %10.4f %6.2f%%", in_degrees(values[0]), in_degrees(values[good / 2]),
              in_degrees(values[good - 1]), 100.0 * (double)inside / (double)good);
    }
    fputc('\n', file);
  }
  free(values);
  return true;
}

static bool write_file(const char *name, void (*print)(const struct map *, FILE *), const struct map *map) {
  FILE *file = strcmp(name, "-") == 0 ? stdout : output_open(name);
  if (file == NULL) return false;
  print(map, file);
  return file == stdout || output_close(file, name);
}

static int study(const struct options *options) {
  struct map map = {options, (int)floor(options->tilt / options->step + 1e-9) + 1,
                    (int)ceil(360.0 / options->step - 1e-9), NULL};
  const long rows = (long)options->sigma_count * map.thetas;
  map.nodes = malloc((size_t)rows * (size_t)map.phis * sizeof *map.nodes);
  if (map.nodes == NULL) {
    complain("not enough memory for %ld orientations", rows * map.phis);
    return UNUSABLE;
  }
  bool good = sweep(rows, (int)options->threads, study_row, &map);
  const bool to_stdout = options->out != NULL && strcmp(options->out, "-") == 0;
  if (good && options->out != NULL) good = write_file(options->out, print_csv, &map);
  if (good) good = print_summary(&map, to_stdout ? stderr : stdout);
  free(map.nodes);
  return good ? ALL_WELL : UNUSABLE;
}

/* ---- The singular curves ---- */

/* The platform with v_i along u_i or against it, turned about it: column j of R is u_i or -u_i, k the one after it. */
static void curve_point(int leg, int sign, double angle, double R[9]) {
  const int j = (leg + 1) % 3;
  const int k = (leg + 2) % 3;
  const double c = cos(angle);
  const double s = sin(angle);
  memset(R, 0, 9 * sizeof *R);
  R[3 * leg + j] = sign;
  R[3 * j + k] = c;
  R[3 * k + k] = s;
  R[3 * j + leg] = -sign * s;
  R[3 * k + leg] = sign * c;
}

static void print_curves(const struct map *map, FILE *file) {
  (void)map;
  fputs("leg,sign,angle_deg,phi_deg,theta_deg,sigma_deg\n", file);
  for (int curve = 0; curve < 6; ++curve) {
    for (int degree = 0; degree <= 360; ++degree) {
      double R[9];
      double phi, theta, sigma;
      curve_point(curve / 2, curve % 2 ? -1 : 1, in_radians(degree), R);
      chs_agile_eye_tool(R, R);
      if (chs_tilt_from_rotation(R, &phi, &theta, &sigma) < 0) continue;
      fprintf(file, "%d,%d,%d,%.9g,%.9g,%.9g\n", curve / 2 + 1, curve % 2 ? -1 : 1, degree, in_degrees(phi),
              in_degrees(theta), in_degrees(sigma));
    }
  }
}

/* ---- Options ---- */

static bool read_sigmas(const char *word, struct options *options) {
  options->sigma_count = read_number_list(word, options->sigmas, MOST_SIGMAS);
  bool good = options->sigma_count > 0;
  for (int i = 0; i < options->sigma_count; ++i) good = good && fabs(options->sigmas[i]) <= MOST_DEGREES;
  if (good) return true;
  complain("--sigma expects up to %d numbers from -%d to %d as 0,60 or 0,20,...,120, not '%s'", MOST_SIGMAS,
           MOST_DEGREES, MOST_DEGREES, word);
  return false;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"sigma", required_argument, NULL, 's'},
                                        {"epsilon", required_argument, NULL, 'e'},
                                        {"step", required_argument, NULL, 'd'},
                                        {"tilt", required_argument, NULL, 'x'},
                                        {"grid", required_argument, NULL, 'g'},
                                        {"refine", required_argument, NULL, 'r'},
                                        {"out", required_argument, NULL, 'o'},
                                        {"threads", required_argument, NULL, 't'},
                                        {"help", no_argument, NULL, 'h'},
                                        {"curves", required_argument, NULL, 'c'},
                                        {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 's': good = read_sigmas(optarg, options); break;
    case 'e': good = option_epsilon(optarg, &options->epsilon); break;
    case 'd': good = option_degrees("step", optarg, 0.1, 90.0, &options->step); break;
    case 'x': good = option_degrees("tilt", optarg, 0.0, 180.0, &options->tilt); break;
    case 'g': good = option_count("grid", optarg, 2, 101, &options->grid); break;
    case 'r': good = option_count("refine", optarg, 0, 40, &options->refine); break;
    case 't': good = option_count("threads", optarg, 1, MOST_THREADS, &options->threads); break;
    case 'o': options->out = optarg; break;
    case 'c': options->curves = optarg; break;
    case 'h': fputs(agile_eye_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (!good) return UNUSABLE;
  if (optind == argc) return -1;
  complain("agile-eye takes options only, not '%s'; see 'chasles help agile-eye'", argv[optind]);
  return UNUSABLE;
}

int agile_eye_command(int argc, char **argv) {
  struct options options = {
      {0, 20, 40, 60, 80, 100, 120}, 7, in_radians(0.01), 1.0, 180.0, 3, 4, core_count(), NULL, NULL};
  const int status = read_options(argc, argv, &options);
  if (status != -1) return status;
  if (options.curves != NULL) return write_file(options.curves, print_curves, NULL) ? ALL_WELL : UNUSABLE;
  return study(&options);
}
