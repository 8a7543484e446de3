/* solve.c - chasles solve: the screw motion of a body from three measured markers, frame by frame. */
#include <chasles/chasles.h>
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "angles.h"
#include "commands.h"
#include "markers.h"
#include "text.h"

const char solve_help[] =
    "usage: chasles solve [options] FILE.csv\n"
    "\n"
    "Reads the positions of markers, one row a frame, and prints the screw that brings a body from a reference frame\n"
    "to each frame: the angle, the axis' direction, the axis' point nearest to the origin, and the translation along\n"
    "the axis. A frame in which one of the three markers is missing is reported as such and skipped, never guessed.\n"
    "\n"
    "The first row names the columns: NAME_x, NAME_y, NAME_z for each marker, with the unit behind it if there is\n"
    "one (Head1_x_m), and first, if wanted, the time (time_s). An empty cell, nan or NA is a missing coordinate.\n"
    "Cells are parted by commas, semicolons or tabs, numbers have a decimal point; '-' is standard input.\n"
    "\n"
    "options:\n"
    "  --markers A,B,C    the three markers of the body (default: the first three of the file)\n"
    "  --against FRAME    the reference: 'first', the first frame with all three markers; 'previous', the last frame\n"
    "                     before that had all three; or the number of a frame, from 1 (default: first)\n"
    "  --method NAME      bottema-roth or laub-shiflett (default: laub-shiflett, which measuring\n"
    "                     errors disturb less; bottema-roth is the faster)\n"
    "  --tolerance X      largest change of a side of the triangle, as a part of its longest side, that still counts\n"
    "                     as rigid (default: 0.05, since markers on skin shift by a few percent of their distances;\n"
    "                     a mistaken marker changes them by far more)\n"
    "  --degrees          angles in degrees also in CSV (default: degrees in the table, radians in CSV)\n"
    "  --out FILE         write CSV to FILE, '-' for standard output, in place of the table\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  every frame with all three markers was solved\n"
    "  1  some was not (points on a line, sides that changed), or no frame has all three markers\n"
    "  2  unusable input or arguments, or an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles solve --markers Arm1,Arm2,Arm3 trial.csv\n"
    "  chasles solve --against previous --method bottema-roth --out screws.csv trial.csv\n";

typedef int method_function(const double *initial, const double *final, double tolerance, chs_screw *screw, double *T);

struct method {
  const char *name;
  method_function *solve;
};

static const struct method methods[] = {
    {"laub-shiflett", chs_motion_laub_shiflett},
    {"bottema-roth", chs_motion_bottema_roth},
};

enum { METHODS = (int)(sizeof methods / sizeof methods[0]) };
enum { AGAINST_FIRST = 0, AGAINST_PREVIOUS = -1 }; /* or the number of a frame */

struct options {
  const char *file;
  const char *markers;
  const struct method *method;
  long against;
  double tolerance;
  bool degrees;
  const char *out;
};

/* A run through the file. */
struct run {
  const struct options *options;
  struct markers markers;
  int chosen[3];
  const char *unit;
  FILE *csv; /* NULL: the table is printed */
  bool has_reference;
  struct frame reference;
  long frames;
  long missing;
  long solved;
  long failed;
};

/* What is printed of a frame. */
struct result {
  const struct frame *frame;
  bool is_reference;
  bool is_missing;
  long against; /* number of the reference frame */
  int status;   /* when it is neither of the two above */
  chs_screw screw;
};

/* ---- Markers ---- */

static void print_marker_names(const struct markers *markers) {
  for (int i = 0; i < markers->count; ++i) fprintf(stderr, " %s", markers->list[i].name);
  fputc('\n', stderr);
}

static bool unknown_marker(const struct markers *markers, const char *name, size_t length) {
  complain("%s has no marker '%.*s'; it has", markers->text.name, (int)length, name);
  print_marker_names(markers);
  return false;
}

static bool choose_named(struct run *run, const char *names) {
  for (int i = 0; i < 3; ++i) {
    names += strspn(names, " ");
    const size_t length = strcspn(names, ",");
    run->chosen[i] = markers_find(&run->markers, names, length);
    if (run->chosen[i] < 0) return unknown_marker(&run->markers, names, length);
    names += length;
    if (*names == ',' && i < 2) ++names;
  }
  return true;
}

static void choose_first_three(struct run *run) {
  for (int i = 0; i < 3; ++i) run->chosen[i] = i;
  if (run->markers.count == 3) return;
  complain("no --markers given: the first three are taken of");
  print_marker_names(&run->markers);
}

static bool choose_markers(struct run *run) {
  const struct marker *list = run->markers.list;
  if (run->markers.count < 3) {
    text_expected(&run->markers.text, run->markers.count == 0 ? "" : list[0].name,
                  "columns NAME_x, NAME_y, NAME_z of at least three markers");
    return false;
  }
  if (run->options->markers == NULL) {
    choose_first_three(run);
  } else if (!choose_named(run, run->options->markers)) {
    return false;
  }
  run->unit = list[run->chosen[0]].unit;
  for (int i = 1; i < 3; ++i) {
    const struct marker *marker = &list[run->chosen[i]];
    if (strcmp(marker->unit, run->unit) == 0) continue;
    text_expected(&run->markers.text, marker->unit, "the unit '%s' of marker %s for %s as well", run->unit,
                  list[run->chosen[0]].name, marker->name);
    return false;
  }
  return true;
}

static bool is_complete(const struct frame *frame) {
  return frame->present[0] && frame->present[1] && frame->present[2];
}

/* ---- Output ---- */

static void print_quoted(FILE *file, const char *text) {
  fputc('"', file);
  for (; *text != '\0'; ++text) {
    if (*text == '"') fputc('"', file);
    fputc(*text, file);
  }
  fputc('"', file);
}

/* "point_x" with the unit of the file: "point_x_m" */
static void print_title(FILE *file, int width, const char *title, const char *unit) {
  char full[64];
  snprintf(full, sizeof full, "%s%s%.32s", title, *unit == '\0' ? "" : "_", unit);
  fprintf(file, " %*s", width, full);
}

static void print_table_titles(const struct run *run) {
  printf("%6s", "frame");
  if (run->markers.has_time) printf(" %10.10s", run->markers.time_title);
  printf(" %6s %10s %8s %8s %8s", "from", "angle_deg", "axis_x", "axis_y", "axis_z");
  print_title(stdout, 11, "point_x", run->unit);
  print_title(stdout, 11, "point_y", run->unit);
  print_title(stdout, 11, "point_z", run->unit);
  print_title(stdout, 13, "translation", run->unit);
  puts("  status");
}

static void print_csv_titles(const struct run *run) {
  FILE *file = run->csv;
  const char *joint = *run->unit == '\0' ? "" : "_";
  fputs("frame,", file);
  if (run->markers.has_time) {
    print_quoted(file, run->markers.time_title);
    fputc(',', file);
  }
  fprintf(file, "from,angle_%s,axis_x,axis_y,axis_z,", run->options->degrees ? "deg" : "rad");
  for (int axis = 0; axis < 3; ++axis) fprintf(file, "point_%c%s%s,", "xyz"[axis], joint, run -> unit);
  fprintf(file, "translation%s%s,status,note\n", joint, run->unit);
}

/* In words: why there is no screw, or what the library says of it. */
static void print_note(FILE *file, const struct run *run, const struct result *result) {
  if (result->is_missing) {
    fputs("missing:", file);
    for (int k = 0; k < 3; ++k) {
      if (!result->frame->present[k]) fprintf(file, " %s", run->markers.list[run->chosen[k]].name);
    }
  } else {
    fputs(result->is_reference ? "reference" : chs_status_text(result->status), file);
  }
}

static bool has_screw(const struct result *result) {
  return !result->is_missing && !result->is_reference && result->status >= 0;
}

static void print_table_row(const struct run *run, const struct result *result) {
  const chs_screw *screw = &result->screw;
  printf("%6ld", result->frame->number);
  if (run->markers.has_time) printf(" %10.6f", result->frame->time);
  if (result->is_missing || result->is_reference) {
    printf(" %6s", "");
  } else {
    printf(" %6ld", result->against);
  }
  if (has_screw(result)) {
    printf(" %10.5f", in_degrees(screw->angle));
    for (int i = 0; i < 3; ++i) printf(" %8.5f", screw->axis[i]);
    for (int i = 0; i < 3; ++i) printf(" %11.5g", screw->point[i]);
    printf(" %13.5g", screw->translation);
  } else {
    printf(" %87s", "");
  }
  fputs("  ", stdout);
  print_note(stdout, run, result);
  putchar('\n');
}

static void print_csv_row(const struct run *run, const struct result *result) {
  FILE *file = run->csv;
  const chs_screw *screw = &result->screw;
  const double numbers[] = {run->options->degrees ? in_degrees(screw->angle) : screw->angle,
                            screw->axis[0],
                            screw->axis[1],
                            screw->axis[2],
                            screw->point[0],
                            screw->point[1],
                            screw->point[2],
                            screw->translation};
  fprintf(file, "%ld,", result->frame->number);
  if (run->markers.has_time) {
    if (!isnan(result->frame->time)) print_shortest(file, result->frame->time);
    fputc(',', file);
  }
  if (!result->is_missing && !result->is_reference) fprintf(file, "%ld", result->against);
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
    fputc(',', file);
    if (has_screw(result)) print_shortest(file, numbers[i]);
  }
  fputc(',', file);
  if (!result->is_missing && !result->is_reference) fprintf(file, "%d", result->status);
  fputs(",\"", file);
  print_note(file, run, result);
  fputs("\"\n", file);
}

static void print_summary(const struct run *run) {
  const struct marker *list = run->markers.list;
  FILE *file = run->csv == stdout ? stderr : stdout;
  fprintf(file, "%s%s, %s, %s by %s: %ld frames, %ld solved, %ld with a marker missing, %ld in error\n",
          run->csv == NULL ? "\n" : "", list[run->chosen[0]].name, list[run->chosen[1]].name, list[run->chosen[2]].name,
          run->options->method->name, run->frames, run->solved, run->missing, run->failed);
}

/* ---- Solving ---- */

static struct result solve_frame(const struct run *run, const struct frame *frame) {
  struct result result;
  memset(&result, 0, sizeof result);
  result.frame = frame;
  result.is_missing = !is_complete(frame);
  result.is_reference = !result.is_missing && (!run->has_reference || frame->number == run->reference.number);
  if (result.is_missing || result.is_reference) return result;
  result.against = run->reference.number;
  result.status =
      run->options->method->solve(run->reference.points, frame->points, run->options->tolerance, &result.screw, NULL);
  return result;
}

static void count_result(struct run *run, const struct result *result) {
  ++run->frames;
  if (result->is_missing) {
    ++run->missing;
  } else if (!result->is_reference) {
    ++*(result->status < 0 ? &run->failed : &run->solved);
  }
}

static void print_result(const struct run *run, const struct result *result) {
  if (run->csv == NULL) {
    print_table_row(run, result);
  } else {
    print_csv_row(run, result);
  }
}

static bool solve_frames(struct run *run) {
  struct frame frame;
  enum text_result read;
  if (run->csv == NULL) {
    print_table_titles(run);
  } else {
    print_csv_titles(run);
  }
  while ((read = markers_next(&run->markers, run->chosen, &frame)) == TEXT_LINE) {
    const struct result result = solve_frame(run, &frame);
    print_result(run, &result);
    count_result(run, &result);
    if (result.is_missing) continue;
    if (!run->has_reference || run->options->against == AGAINST_PREVIOUS) run->reference = frame;
    run->has_reference = true;
  }
  return read == TEXT_END;
}

static bool open_markers(struct run *run) {
  if (!markers_open(&run->markers, run->options->file)) return false;
  if (choose_markers(run)) return true;
  markers_close(&run->markers);
  return false;
}

/* Reads the file up to the frame that --against names. */
static bool find_reference(struct run *run) {
  const long wanted = run->options->against;
  enum text_result read = TEXT_LINE;
  if (!open_markers(run)) return false;
  while (run->reference.number != wanted && read == TEXT_LINE) {
    read = markers_next(&run->markers, run->chosen, &run->reference);
  }
  if (read == TEXT_END) {
    complain("%s has no frame %ld: it ends with frame %ld", run->markers.text.name, wanted, run->markers.frame);
  } else if (read == TEXT_LINE && !is_complete(&run->reference)) {
    complain("%s:%ld: frame %ld cannot be the reference, a marker is missing in it", run->markers.text.name,
             run->reference.line, wanted);
  } else {
    run->has_reference = read == TEXT_LINE;
  }
  markers_close(&run->markers);
  return run->has_reference;
}

static bool is_same_file(FILE *file, const char *name) {
  struct stat a, b;
  return fstat(fileno(file), &a) == 0 && stat(name, &b) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

static bool open_output(struct run *run) {
  const char *out = run->options->out;
  if (out == NULL) return true;
  if (strcmp(out, "-") != 0 && is_same_file(run->markers.text.file, out)) {
    complain("--out %s is the input itself", out);
    return false;
  }
  run->csv = strcmp(out, "-") == 0 ? stdout : output_open(out);
  return run->csv != NULL;
}

static int solve(const struct options *options) {
  struct run run;
  memset(&run, 0, sizeof run);
  run.options = options;
  if (options->against > 0 && !find_reference(&run)) return UNUSABLE;
  if (!open_markers(&run)) return UNUSABLE;
  bool good = open_output(&run);
  if (good) {
    good = solve_frames(&run);
    if (good) print_summary(&run);
    if (run.csv != NULL && run.csv != stdout && !output_close(run.csv, options->out)) good = false;
  }
  markers_close(&run.markers);
  if (!good) return UNUSABLE;
  if (!run.has_reference) complain("no frame has all three markers");
  return run.has_reference && run.failed == 0 ? ALL_WELL : SOMETHING_OVER;
}

/* ---- Options ---- */

static bool read_method(const char *name, struct options *options) {
  for (int i = 0; i < METHODS; ++i) {
    options->method = &methods[i];
    if (strcmp(methods[i].name, name) == 0) return true;
  }
  complain("--method expects bottema-roth or laub-shiflett, not '%s'", name);
  return false;
}

static bool read_against(const char *word, struct options *options) {
  if (strcmp(word, "first") == 0) {
    options->against = AGAINST_FIRST;
  } else if (strcmp(word, "previous") == 0) {
    options->against = AGAINST_PREVIOUS;
  } else if (!parse_integer(word, 1, 2147483647, &options->against)) {
    complain("--against expects first, previous or the number of a frame, not '%s'", word);
    return false;
  }
  return true;
}

static bool read_tolerance(const char *word, struct options *options) {
  if (read_number(word, &options->tolerance) && options->tolerance >= 0.0) return true;
  complain("--tolerance expects a number of at least 0, not '%s'", word);
  return false;
}

/* Three names, all different, parted by commas. */
static bool read_markers(const char *names, struct options *options) {
  const char *second = strchr(names, ',');
  const char *third = second == NULL ? NULL : strchr(second + 1, ',');
  options->markers = names;
  if (third != NULL && strchr(third + 1, ',') == NULL) {
    const size_t a = (size_t)(second - names);
    const size_t b = (size_t)(third - second - 1);
    const size_t c = strlen(third + 1);
    const bool ab = a == b && strncmp(names, second + 1, a) == 0;
    const bool bc = b == c && strncmp(second + 1, third + 1, b) == 0;
    const bool ca = c == a && strncmp(third + 1, names, c) == 0;
    if (!ab && !bc && !ca) return true;
  }
  complain("--markers expects three different names parted by commas, not '%s'", names);
  return false;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {
      {"markers", required_argument, NULL, 'k'}, {"against", required_argument, NULL, 'a'},
      {"method", required_argument, NULL, 'm'},  {"tolerance", required_argument, NULL, 't'},
      {"degrees", no_argument, NULL, 'd'},       {"out", required_argument, NULL, 'o'},
      {"help", no_argument, NULL, 'h'},          {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'k': good = read_markers(optarg, options); break;
    case 'a': good = read_against(optarg, options); break;
    case 'm': good = read_method(optarg, options); break;
    case 't': good = read_tolerance(optarg, options); break;
    case 'd': options->degrees = true; break;
    case 'o': options->out = optarg; break;
    case 'h': fputs(solve_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (!good) return UNUSABLE;
  if (optind != argc - 1) {
    complain("solve expects one file of markers; see 'chasles help solve'");
    return UNUSABLE;
  }
  options->file = argv[optind];
  if (options->against > 0 && strcmp(options->file, "-") == 0) {
    complain("--against a frame's number reads the file twice, which standard input does not allow");
    return UNUSABLE;
  }
  return -1;
}

int solve_command(int argc, char **argv) {
  struct options options = {NULL, NULL, &methods[0], AGAINST_FIRST, 0.05, false, NULL};
  const int status = read_options(argc, argv, &options);
  return status == -1 ? solve(&options) : status;
}
