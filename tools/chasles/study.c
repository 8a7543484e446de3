/* study.c - chasles study: the comparison of Fenton & Shi 1990, section 4, done again with the library's methods.
 *
 * What the paper leaves open is drawn as in its appendix: points in a cube of side 4, e_x and e_y in [0, 1], A_x, A_y
 * and u in [0, 2]. Angles are 0.1 to 3 rad: at smaller ones the place of the axis is lost to the data's errors by any
 * method, and a single such motion would decide a mean.
 */
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "commands.h"
#include "evaluate.h"
#include "methods.h"
#include "random.h"
#include "text.h"

const char study_help[] =
    "usage: chasles study [options]\n"
    "\n"
    "Compares the methods for three points as R. G. Fenton and X. Shi did in 1990: how fast they are (Table 1), how\n"
    "exact (Tables 2 and 3), and how much errors of the data disturb them (figures 4 to 7), in double and in float,\n"
    "with the paper's values beside ours; and how exact they are at small angles and near a half-turn, which the paper\n"
    "does not ask. Errors of the data scale a whole triangle by 1 + or - E, as in the paper, or are independent noise\n"
    "in each coordinate, as measuring gives it. (Of these the table is for double; the CSV has float as well.)\n"
    "\n"
    "options:\n"
    "  --sets N         motions for efficiency and accuracy (default: 200, as in the paper)\n"
    "  --noisy-sets N   motions for each level of error (default: 100, as in the paper)\n"
    "  --seed N         start of the random motions, 0 to 2147483647 (default: 1)\n"
    "  --out DIR        also write efficiency.csv, accuracy.csv, sensitivity.csv and angles.csv into this directory,\n"
    "                   made if need be; tools/study/methods.py draws the figures from them\n"
    "  --help           print this help\n"
    "\n"
    "exit status:\n"
    "  0  every motion was solved by every method\n"
    "  1  some was not\n"
    "  2  unusable arguments, or an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles study\n"
    "  chasles study --out study && python3 tools/study/methods.py study\n";

enum { MOST_SETS = 100000, PARAMETERS = 6, MERITS = 4, ROUNDS = 41 };

static const double half_turn = 3.14159265358979323846;

struct options {
  long sets;
  long noisy_sets;
  long seed;
  const char *out;
};

/* ---- The paper's values, methods in the order of methods.c ---- */

static const double paper_times[] = {8.748, 4.680, 5.360, 0.406, 1.674}; /* ms, Table 1 */
static const double paper_time_deviations[] = {0.162, 0.104, 0.453, 0.042, 0.107};
static const double paper_means[PARAMETERS][5] = {
    {-3.46, 1.47, 97.28, 5.56, -111.93}, /* 1e-6, Table 2 */
    {-0.11, -0.32, 7.41, 0.95, 348.25},  {-3.84, 11.28, -130.97, 3.58, 12.98}, {1.03, 2.08, 46.95, -37.06, 108.85},
    {0.06, 0.16, -6.88, -0.11, 24.32},   {-0.34, 0.49, 25.43, 0.29, 1.00}};
static const double paper_deviations[PARAMETERS][5] = {
    {18.76, 12.36, 1174.39, 44.72, 983.29}, /* 1e-6, Table 3 */
    {13.53, 14.02, 409.77, 62.36, 2669.05}, {24.20, 91.07, 1182.67, 69.97, 381.07},
    {23.98, 38.84, 525.67, 394.51, 739.63}, {1.64, 3.44, 52.49, 2.39, 153.80},
    {2.42, 4.78, 317.21, 3.38, 21.94}};
static const char *const parameter_names[PARAMETERS] = {"e_x", "e_y", "A_x", "A_y", "u", "theta"};

/* ---- A run, and its files ---- */

struct run {
  const struct options *options;
  uint64_t random;
  long failures; /* motions that a method did not solve */
  bool written;  /* every file was */
};

/* A CSV file of that name in --out, with its titles; NULL where there is no --out, or with a message. */
static FILE *open_csv(struct run *run, const char *name, const char *titles) {
  char path[4096];
  if (run->options->out == NULL) return NULL;
  const int length = snprintf(path, sizeof path, "%s/%s.csv", run->options->out, name);
  FILE *file = length < (int)sizeof path ? output_open(path) : NULL;
  if (file == NULL) {
    run->written = false;
  } else {
    fprintf(file, "%s\n", titles);
  }
  return file;
}

static void close_csv(struct run *run, FILE *file, const char *name) {
  if (file != NULL && !output_close(file, name)) run->written = false;
}

/* ---- Motions ---- */

struct motion {
  double initial[9];
  double final[9];
  chs_screw screw;
  double T[16];
};

static double distance(const double *a, const double *b) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sqrt(sum);
}

/* Points whose smallest height is less than a tenth of the longest side are nearly on a line. */
static bool is_thin(const double points[9]) {
  double longest = 0.0, half = 0.0, area = 1.0, sides[3];
  for (int k = 0; k < 3; ++k) {
    sides[k] = distance(points + 3 * k, points + 3 * ((k + 1) % 3));
    longest = fmax(longest, sides[k]);
    half += 0.5 * sides[k];
  }
  area = half;
  for (int k = 0; k < 3; ++k) area *= half - sides[k];
  return 2.0 * sqrt(fmax(area, 0.0)) < 0.1 * longest * longest;
}

/* e and A with their constraints e.e = 1 and e.A = 0; e_z is at least 0.2, so that A_z is of the size of the rest. */
static chs_screw draw_screw(uint64_t *random, double angle) {
  chs_screw screw;
  double square;
  do {
    screw.axis[0] = uniform(random, 0.0, 1.0);
    screw.axis[1] = uniform(random, 0.0, 1.0);
    square = screw.axis[0] * screw.axis[0] + screw.axis[1] * screw.axis[1];
  } while (square > 0.96);
  screw.axis[2] = sqrt(1.0 - square);
  screw.point[0] = uniform(random, 0.0, 2.0);
  screw.point[1] = uniform(random, 0.0, 2.0);
  screw.point[2] = -(screw.axis[0] * screw.point[0] + screw.axis[1] * screw.point[1]) / screw.axis[2];
  screw.translation = uniform(random, 0.0, 2.0);
  screw.angle = angle;
  return screw;
}

static void move_points(const double T[16], const double initial[9], double final[9]) {
  for (int k = 0; k < 3; ++k) chs_se3_apply(T, initial + 3 * k, final + 3 * k);
}

static struct motion draw_motion_by(uint64_t *random, double angle) {
  struct motion motion;
  do {
    for (int i = 0; i < 9; ++i) motion.initial[i] = uniform(random, 0.0, 4.0);
  } while (is_thin(motion.initial));
  motion.screw = draw_screw(random, angle);
  chs_screw_to_pose(&motion.screw, motion.T);
  move_points(motion.T, motion.initial, motion.final);
  return motion;
}

static struct motion draw_motion(uint64_t *random) {
  const double angle = uniform(random, 0.1, 3.0);
  return draw_motion_by(random, angle);
}

/* ---- Solutions ---- */

struct solution {
  int status;
  chs_screw screw;
  double T[16];
};

static void narrow(const double *from, int count, float *to) {
  for (int i = 0; i < count; ++i) to[i] = (float)from[i];
}

static void widen(const float *from, int count, double *to) {
  for (int i = 0; i < count; ++i) to[i] = (double)from[i];
}

/* The tolerance lets every triangle of the study pass. */
static struct solution solve_in(enum precision precision, const struct method *method, const double *initial,
                                const double *final) {
  struct solution solution;
  memset(&solution, 0, sizeof solution);
  if (precision == DOUBLE_PRECISION) {
    solution.status = method->solve(initial, final, 1.0, &solution.screw, solution.T);
    return solution;
  }
  float initialf[9], finalf[9], T[16] = {0.0F};
  chs_screwf screw = {{0.0F}, {0.0F}, 0.0F, 0.0F};
  narrow(initial, 9, initialf);
  narrow(final, 9, finalf);
  solution.status = method->solvef(initialf, finalf, 1.0F, &screw, T);
  widen(screw.axis, 3, solution.screw.axis);
  widen(screw.point, 3, solution.screw.point);
  solution.screw.translation = (double)screw.translation;
  solution.screw.angle = (double)screw.angle;
  widen(T, 16, solution.T);
  return solution;
}

/* The same displacement with its axis on the side of the given one: near a half-turn both signs are right, and data
 * errors may take the angle beyond it. */
static void face(chs_screw *screw, const double axis[3]) {
  double along = 0.0;
  for (int i = 0; i < 3; ++i) along += screw->axis[i] * axis[i];
  if (along >= 0.0 || screw->angle < 0.5 * half_turn) return;
  for (int i = 0; i < 3; ++i) screw->axis[i] = -screw->axis[i];
  screw->translation = -screw->translation;
  screw->angle = 2.0 * half_turn - screw->angle;
}

/* The screw that a method finds, facing the true one; false where it finds none. */
static bool find_screw(struct run *run, enum precision precision, const struct method *method, const double *initial,
                       const double *final, const struct motion *motion, struct solution *solution) {
  *solution = solve_in(precision, method, initial, final);
  if (solution->status < 0) {
    ++run->failures;
    return false;
  }
  face(&solution->screw, motion->screw.axis);
  return true;
}

/* ---- Statistics ---- */

struct statistics {
  double mean;
  double deviation;
  double median; /* of the sizes, */
  double spread; /* and half of the distance between their quartiles */
  double largest;
};

static int compare_numbers(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Sorts x by size and forgets its signs. */
static struct statistics statistics_of(double *x, long count) {
  struct statistics s = {0.0, 0.0, 0.0, 0.0, 0.0};
  if (count == 0) return s;
  for (long i = 0; i < count; ++i) s.mean += x[i] / (double)count;
  for (long i = 0; i < count; ++i) s.deviation += (x[i] - s.mean) * (x[i] - s.mean);
  s.deviation = count > 1 ? sqrt(s.deviation / (double)(count - 1)) : 0.0;
  for (long i = 0; i < count; ++i) x[i] = fabs(x[i]);
  qsort(x, (size_t)count, sizeof *x, compare_numbers);
  s.median = 0.5 * (x[(count - 1) / 2] + x[count / 2]);
  s.spread = 0.5 * (x[3 * (count - 1) / 4] - x[(count - 1) / 4]);
  s.largest = x[count - 1];
  return s;
}

static void print_method_titles(int before) {
  printf("%*s", before, "");
  for (int m = 0; m < METHODS_FOR_THREE; ++m) printf(" %17s", methods[m].title);
  putchar('\n');
}

/* ---- Efficiency: Table 1 ---- */

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* Mean time in ns of one call that asks for the screw alone, as the paper's programs did. */
static double time_double(const struct method *method, const struct motion *motions, long sets, int repeats) {
  volatile double sink = 0.0;
  const double start = now();
  for (int r = 0; r < repeats; ++r) {
    for (long k = 0; k < sets; ++k) {
      chs_screw screw;
      if (method->solve(motions[k].initial, motions[k].final, 1.0, &screw, NULL) >= 0) sink = screw.angle;
    }
  }
  (void)sink;
  return (now() - start) / ((double)sets * repeats);
}

static double time_float(const struct method *method, const float *points, long sets, int repeats) {
  volatile float sink = 0.0F;
  const double start = now();
  for (int r = 0; r < repeats; ++r) {
    for (long k = 0; k < sets; ++k) {
      chs_screwf screw;
      if (method->solvef(points + 18 * k, points + 18 * k + 9, 1.0F, &screw, NULL) >= 0) sink = screw.angle;
    }
  }
  (void)sink;
  return (now() - start) / ((double)sets * repeats);
}

static void print_efficiency(struct statistics times[PRECISIONS][METHODS_FOR_THREE], FILE *csv) {
  int base = 0;
  for (int m = 0; m < METHODS_FOR_THREE; ++m) {
    if (strcmp(methods[m].name, "bottema-roth") == 0) base = m;
  }
  puts(
      "Table 1. Execution time of one solution, and how many times that of Bottema & Roth. The paper's in ms on a\n"
      "MIPS-1000 (mean and standard deviation); ours in ns (median of interleaved rounds and half their interquartile\n"
      "range, which other programs on the machine disturb less).\n");
  printf("%-18s %21s %28s %28s\n", "", "paper", "double", "float");
  printf("%-18s %7s %6s %6s  %10s %8s %8s %10s %8s %8s\n", "method", "ms", "dev.", "times", "ns", "dev.", "times", "ns",
         "dev.", "times");
  for (int m = 0; m < METHODS_FOR_THREE; ++m) {
    printf("%-18s %7.3f %6.3f %6.1f ", methods[m].title, paper_times[m], paper_time_deviations[m],
           paper_times[m] / paper_times[base]);
    for (int p = 0; p < PRECISIONS; ++p) {
      const struct statistics *s = &times[p][m];
      const double ratio = s->median / times[p][base].median;
      printf(" %10.1f %8.1f %8.1f", s->median, s->spread, ratio);
      if (csv != NULL) {
        fprintf(csv, "%s,%s,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", methods[m].name, precision_name((enum precision)p),
                s->median, s->spread, ratio, paper_times[m], paper_time_deviations[m],
                paper_times[m] / paper_times[base]);
      }
    }
    putchar('\n');
  }
}

static void study_efficiency(struct run *run, const struct motion *motions, float *points) {
  static double rounds[PRECISIONS][METHODS_FOR_THREE][ROUNDS];
  struct statistics times[PRECISIONS][METHODS_FOR_THREE];
  const long sets = run->options->sets;
  const int repeats = (int)(sets < 2000 ? 2000 / sets + 1 : 1);
  for (long k = 0; k < sets; ++k) {
    narrow(motions[k].initial, 9, points + 18 * k);
    narrow(motions[k].final, 9, points + 18 * k + 9);
  }
  for (int r = 0; r < ROUNDS; ++r) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) {
      rounds[DOUBLE_PRECISION][m][r] = time_double(&methods[m], motions, sets, repeats);
      rounds[FLOAT_PRECISION][m][r] = time_float(&methods[m], points, sets, repeats);
    }
  }
  for (int p = 0; p < PRECISIONS; ++p) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) times[p][m] = statistics_of(rounds[p][m], ROUNDS);
  }
  FILE *csv = open_csv(run, "efficiency",
                       "method,precision,median_ns,spread_ns,times_bottema_roth,paper_mean_ms,paper_deviation_ms,"
                       "paper_times_bottema_roth");
  print_efficiency(times, csv);
  close_csv(run, csv, "efficiency.csv");
}

/* ---- Accuracy: Tables 2 and 3 ---- */

/* The six parameters that the paper calls independent. */
static void independent(const chs_screw *screw, double parameters[PARAMETERS]) {
  const double p[PARAMETERS] = {screw->axis[0],  screw->axis[1],     screw->point[0],
                                screw->point[1], screw->translation, screw->angle};
  memcpy(parameters, p, sizeof p);
}

static void print_table(const char *title, const double paper[PARAMETERS][5], size_t member,
                        struct statistics all[PRECISIONS][PARAMETERS][METHODS_FOR_THREE]) {
  printf("\n%s\n\n", title);
  print_method_titles(13);
  for (int j = 0; j < PARAMETERS; ++j) {
    if (paper != NULL) {
      printf("%-5s %-7s", parameter_names[j], "paper");
      for (int m = 0; m < METHODS_FOR_THREE; ++m) printf(" %17.2f", paper[j][m]);
      putchar('\n');
    }
    for (int p = PRECISIONS - 1; p >= 0; --p) {
      printf("%-5s %-7s", parameter_names[j], precision_name((enum precision)p));
      for (int m = 0; m < METHODS_FOR_THREE; ++m) {
        double value;
        memcpy(&value, (const char *)&all[p][j][m] + member, sizeof value);
        printf(" %17.3g", 1e6 * value);
      }
      putchar('\n');
    }
  }
}

static void write_accuracy(FILE *csv, long set, enum precision precision, const struct method *method,
                           const struct motion *motion, const double errors[PARAMETERS]) {
  if (csv == NULL) return;
  fprintf(csv, "%ld,%s,%s,%.17g", set + 1, precision_name(precision), method->name, motion->screw.angle);
  for (int j = 0; j < PARAMETERS; ++j) fprintf(csv, ",%.6g", errors[j]);
  fputc('\n', csv);
}

static void study_accuracy(struct run *run, const struct motion *motions, double *errors) {
  static struct statistics all[PRECISIONS][PARAMETERS][METHODS_FOR_THREE];
  const long sets = run->options->sets;
  FILE *csv = open_csv(run, "accuracy", "set,precision,method,true_angle_rad,e_x,e_y,A_x,A_y,u,theta");
  for (int p = 0; p < PRECISIONS; ++p) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) {
      long solved = 0;
      for (long k = 0; k < sets; ++k) {
        struct solution found;
        double ours[PARAMETERS], wanted[PARAMETERS], relative[PARAMETERS];
        if (!find_screw(run, (enum precision)p, &methods[m], motions[k].initial, motions[k].final, &motions[k], &found))
          continue;
        independent(&found.screw, ours);
        independent(&motions[k].screw, wanted);
        for (int j = 0; j < PARAMETERS; ++j) {
          relative[j] = (ours[j] - wanted[j]) / fabs(wanted[j]);
          errors[j * sets + solved] = relative[j];
        }
        write_accuracy(csv, k, (enum precision)p, &methods[m], &motions[k], relative);
        ++solved;
      }
      for (int j = 0; j < PARAMETERS; ++j) all[p][j][m] = statistics_of(errors + j * sets, solved);
    }
  }
  close_csv(run, csv, "accuracy.csv");
  print_table("Table 2. Mean relative error of each parameter, in 1e-6 (eq. 32).", paper_means,
              offsetof(struct statistics, mean), all);
  print_table("Table 3. Its standard deviation, in 1e-6.", paper_deviations, offsetof(struct statistics, deviation),
              all);
  print_table(
      "Beyond the paper: the median size of the relative error, in 1e-6, which a few ill-placed motions do not\n"
      "decide as they decide the two tables above.",
      NULL, offsetof(struct statistics, median), all);
}

/* ---- Sensitivity: figures 4 to 7 ---- */

enum error_kind { SCALING, NOISE, KINDS };

static const char *const kind_names[KINDS] = {"scaling", "noise"};
static const double levels[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}; /* percent */
enum { LEVELS = (int)(sizeof levels / sizeof levels[0]) };

/* Eq. 33: the whole set times 1 + e or 1 - e. */
static void scale_points(uint64_t *random, double e, const double *exact, double *inexact) {
  const double factor = next_bits(random) >> 63 ? 1.0 + e : 1.0 - e;
  for (int i = 0; i < 9; ++i) inexact[i] = factor * exact[i];
}

/* Normal noise with a standard deviation of e times the root mean square of the coordinates. */
static void disturb_points(uint64_t *random, double e, const double *exact, double *inexact) {
  double square = 0.0;
  for (int i = 0; i < 9; ++i) square += exact[i] * exact[i] / 9.0;
  for (int i = 0; i < 9; ++i) inexact[i] = exact[i] + e * sqrt(square) * normal(random);
}

/* The squares that eq. 34 to 37 add up, a_4 over the three points. */
static void add_deviations(const struct motion *motion, const struct solution *found, double sums[MERITS]) {
  double reached[9];
  move_points(found->T, motion->initial, reached);
  const double du = found->screw.translation - motion->screw.translation;
  const double dtheta = found->screw.angle - motion->screw.angle;
  const double dA = distance(found->screw.point, motion->screw.point);
  sums[0] += du * du;
  sums[1] += dtheta * dtheta;
  sums[2] += dA * dA;
  for (int k = 0; k < 3; ++k) {
    const double d = distance(reached + 3 * k, motion->final + 3 * k);
    sums[3] += d * d / 3.0;
  }
}

/* a_1 to a_4 of every method, on the same motions with the same errors whatever their level. */
static void measure_sensitivity(struct run *run, enum error_kind kind, double level,
                                double merits[PRECISIONS][METHODS_FOR_THREE][MERITS]) {
  uint64_t random = run->random;
  long solved[PRECISIONS][METHODS_FOR_THREE] = {{0}};
  memset(merits, 0, PRECISIONS * sizeof merits[0]);
  for (long k = 0; k < run->options->noisy_sets; ++k) {
    const struct motion motion = draw_motion(&random);
    double initial[9], final[9];
    void (*spoil)(uint64_t *, double, const double *, double *) = kind == SCALING ? scale_points : disturb_points;
    spoil(&random, level / 100.0, motion.initial, initial);
    spoil(&random, level / 100.0, motion.final, final);
    for (int p = 0; p < PRECISIONS; ++p) {
      for (int m = 0; m < METHODS_FOR_THREE; ++m) {
        struct solution found;
        if (!find_screw(run, (enum precision)p, &methods[m], initial, final, &motion, &found)) continue;
        add_deviations(&motion, &found, merits[p][m]);
        ++solved[p][m];
      }
    }
  }
  for (int p = 0; p < PRECISIONS; ++p) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) {
      for (int a = 0; a < MERITS; ++a) merits[p][m][a] = sqrt(merits[p][m][a] / (double)solved[p][m]);
    }
  }
}

static void write_sensitivity(FILE *csv, enum error_kind kind, double level,
                              double merits[PRECISIONS][METHODS_FOR_THREE][MERITS]) {
  for (int p = 0; csv != NULL && p < PRECISIONS; ++p) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) {
      fprintf(csv, "%s,%g,%s,%s", kind_names[kind], level, precision_name((enum precision)p), methods[m].name);
      for (int a = 0; a < MERITS; ++a) fprintf(csv, ",%.6g", merits[p][m][a]);
      fputc('\n', csv);
    }
  }
}

static void study_sensitivity(struct run *run) {
  static double merits[LEVELS][PRECISIONS][METHODS_FOR_THREE][MERITS];
  static const char *const names[MERITS] = {"a_1, translation u", "a_2, angle theta", "a_3, point A",
                                            "a_4, final points"};
  FILE *csv = open_csv(run, "sensitivity", "kind,level_percent,precision,method,a_1,a_2,a_3,a_4");
  for (int kind = 0; kind < KINDS; ++kind) {
    for (int l = 0; l < LEVELS; ++l) {
      measure_sensitivity(run, (enum error_kind)kind, levels[l], merits[l]);
      write_sensitivity(csv, (enum error_kind)kind, levels[l], merits[l]);
    }
    printf("\nSensitivity to %s, in 1e-4 (eq. 34 to 37; double)\n\n",
           kind == SCALING ? "uniform scaling, as in the paper's figures 4 to 7"
                           : "independent noise in each coordinate");
    print_method_titles(28);
    for (int a = 0; a < MERITS; ++a) {
      for (int l = 0; l < LEVELS; ++l) {
        printf("%-19s %7g%%", names[a], levels[l]);
        for (int m = 0; m < METHODS_FOR_THREE; ++m) printf(" %17.4g", 1e4 * merits[l][DOUBLE_PRECISION][m][a]);
        putchar('\n');
      }
    }
  }
  close_csv(run, csv, "sensitivity.csv");
}

/* ---- Errors against the angle ---- */

enum { ANGLES = 33, MOTIONS_AN_ANGLE = 50 };

/* The errors of the rotation and of the axis, in radians, of one motion. */
static void angle_errors(const struct motion *motion, const struct solution *found, double *rotation, double *axis) {
  double wanted[9], ours[9], p[3];
  chs_se3_to_parts(motion->T, wanted, p);
  chs_se3_to_parts(found->T, ours, p);
  if (chs_so3_angle(wanted, ours, rotation) < 0) *rotation = (double)NAN;
  *axis = distance(found->screw.axis, motion->screw.axis);
}

static void study_angle(struct run *run, FILE *csv, const char *from, double offset, double angle) {
  struct motion motions[MOTIONS_AN_ANGLE];
  uint64_t random = run->random;
  for (int k = 0; k < MOTIONS_AN_ANGLE; ++k) motions[k] = draw_motion_by(&random, angle);
  for (int p = 0; p < PRECISIONS; ++p) {
    for (int m = 0; m < METHODS_FOR_THREE; ++m) {
      double rotation[MOTIONS_AN_ANGLE], axis[MOTIONS_AN_ANGLE];
      long solved = 0;
      for (int k = 0; k < MOTIONS_AN_ANGLE; ++k) {
        struct solution found;
        if (!find_screw(run, (enum precision)p, &methods[m], motions[k].initial, motions[k].final, &motions[k], &found))
          continue;
        angle_errors(&motions[k], &found, &rotation[solved], &axis[solved]);
        ++solved;
      }
      const struct statistics r = statistics_of(rotation, solved), a = statistics_of(axis, solved);
      const double eps = precision_eps((enum precision)p);
      fprintf(csv, "%s,%.6g,%s,%s,%.4g,%.4g,%.4g,%.4g\n", from, offset, precision_name((enum precision)p),
              methods[m].name, r.median / eps, r.largest / eps, a.median / eps, a.largest / eps);
    }
  }
}

/* Angles from 1e-8 to 1 rad, and as far below pi; only for the file, and for the figure drawn from it. */
static void study_angles(struct run *run) {
  FILE *csv = open_csv(run, "angles",
                       "from,offset_rad,precision,method,rotation_median_eps,rotation_largest_eps,axis_median_eps,"
                       "axis_largest_eps");
  for (int k = 0; csv != NULL && k < ANGLES; ++k) {
    const double offset = pow(10.0, -8.0 + 8.0 * k / (ANGLES - 1));
    study_angle(run, csv, "zero", offset, offset);
    study_angle(run, csv, "half_turn", offset, half_turn - offset);
  }
  close_csv(run, csv, "angles.csv");
}

/* ---- The whole ---- */

static bool make_directory(const char *name) {
  struct stat there;
  if (name == NULL || mkdir(name, 0777) == 0) return true;
  if (errno == EEXIST && stat(name, &there) == 0 && S_ISDIR(there.st_mode)) return true;
  complain("cannot make the directory %s: %s", name, strerror(errno));
  return false;
}

static int study(const struct options *options) {
  struct run run = {options, (uint64_t)options->seed, 0, true};
  if (!make_directory(options->out)) return UNUSABLE;
  const size_t sets = (size_t)options->sets;
  struct motion *motions = malloc(sets * sizeof *motions);
  double *errors = malloc(sets * PARAMETERS * sizeof *errors);
  float *points = malloc(sets * 18 * sizeof *points);
  if (motions == NULL || errors == NULL || points == NULL) {
    complain("not enough memory for %ld sets", options->sets);
    run.written = false;
  } else {
    for (size_t k = 0; k < sets; ++k) motions[k] = draw_motion(&run.random);
    study_efficiency(&run, motions, points);
    study_accuracy(&run, motions, errors);
    study_sensitivity(&run);
    study_angles(&run);
    printf("\n%ld sets, %ld for each level of error, seed %ld: %ld not solved\n", options->sets, options->noisy_sets,
           options->seed, run.failures);
  }
  free(motions);
  free(errors);
  free(points);
  if (!run.written) return UNUSABLE;
  return run.failures == 0 ? ALL_WELL : SOMETHING_OVER;
}

static bool read_count(const char *option, const char *word, long least, long most, long *count) {
  if (parse_integer(word, least, most, count)) return true;
  complain("%s expects a number from %ld to %ld, not '%s'", option, least, most, word);
  return false;
}

int study_command(int argc, char **argv) {
  static const struct option names[] = {
      {"sets", required_argument, NULL, 'n'}, {"noisy-sets", required_argument, NULL, 'e'},
      {"seed", required_argument, NULL, 's'}, {"out", required_argument, NULL, 'o'},
      {"help", no_argument, NULL, 'h'},       {NULL, 0, NULL, 0}};
  struct options options = {200, 100, 1, NULL};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'n': good = read_count("--sets", optarg, 1, MOST_SETS, &options.sets); break;
    case 'e': good = read_count("--noisy-sets", optarg, 1, MOST_SETS, &options.noisy_sets); break;
    case 's': good = read_count("--seed", optarg, 0, 2147483647, &options.seed); break;
    case 'o': options.out = optarg; break;
    case 'h': fputs(study_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (good && optind != argc) {
    complain("study takes no argument '%s'; see 'chasles help study'", argv[optind]);
    good = false;
  }
  return good ? study(&options) : UNUSABLE;
}
