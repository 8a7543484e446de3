/* solve.c - chasles solve: the screw motion of a body from its measured markers, frame by frame. */
#include <chasles/chasles.h>
#include <getopt.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "angles.h"
#include "commands.h"
#include "markers.h"
#include "methods.h"
#include "text.h"

const char solve_help[] =
    "usage: chasles solve [options] FILE.csv\n"
    "\n"
    "Reads the positions of markers, one row a frame, and prints the screw that brings a body from a reference frame\n"
    "to each frame: the angle, the axis' direction, the axis' point nearest to the origin, the translation along the\n"
    "axis, and the root mean square distance that the markers keep from where the screw takes them. A frame in which\n"
    "a marker is missing is reported as such and skipped, never guessed; of a body of more than three the others are\n"
    "used, and that is reported.\n"
    "\n"
    "The first row names the columns: NAME_x, NAME_y, NAME_z for each marker, with the unit behind it if there is\n"
    "one (Head1_x_m), and first, if wanted, the time (time_s). An empty cell, nan or NA is a missing coordinate.\n"
    "Cells are parted by commas, semicolons or tabs, numbers have a decimal point; '-' is standard input.\n"
    "\n"
    "options:\n"
    "  --markers A,B,C,...      the markers of the body, three or more\n"
    "  --points N               without --markers: the first N markers of the file (default: 3)\n"
    "  --relative-to D,E,F,...  the motion relative to a second body, as somebody sees it who is fixed to that one: a\n"
    "                           forearm relative to the arm. Axes and points are in coordinates that move with the\n"
    "                           second body and are the file's own in its first complete frame, or in that of\n"
    "                           --against NUMBER\n"
    "  --against FRAME          the reference: 'first', the first frame with all markers; 'previous', the last frame\n"
    "                           before that had all of them; or the number of a frame, from 1 (default: first)\n"
    "  --method NAME            least-squares, for any number of markers; for three also spoor-veldpaus, laub-shiflett,\n"
    "                           angeles, beggs or bottema-roth (default: least-squares, which measuring errors disturb\n"
    "                           least; bottema-roth is the fastest)\n"
    "  --all-methods            a line for each of the methods\n"
    "  --weights W1,W2,...      of the markers of the body, in their order: one over the square of the error\n"
    "  --covariance SIGMA       also the standard deviations of angle (radians, in the table degrees), axis (radians),\n"
    "                           point and translation, where each coordinate of a marker of weight 1 has the standard\n"
    "                           deviation SIGMA in both frames, in the unit of the file; not with --relative-to\n"
    "  --tolerance X            largest change of shape that still counts as rigid: the root mean square distance over\n"
    "                           that of the markers from their centroid; with the methods for three, the change of a\n"
    "                           side over the longest (default: 0.05, since markers on skin shift by a few percent of\n"
    "                           their distances; a mistaken marker changes them by far more)\n"
    "  --degrees                angles in degrees also in CSV (default: degrees in the table, radians in CSV)\n"
    "  --out FILE               write CSV to FILE, '-' for standard output, in place of the table\n"
    "  --help                   print this help\n"
    "\n"
    "exit status:\n"
    "  0  every frame with all markers was solved\n"
    "  1  some was not (points on a line, a changed shape), or no frame has all markers\n"
    "  2  unusable input or arguments, or an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles solve --markers Arm1,Arm2,Arm3 trial.csv\n"
    "  chasles solve --markers Forearm1,Forearm2,Forearm3 --relative-to Arm1,Arm2,Arm3 --out elbow.csv trial.csv\n"
    "  chasles solve --against previous --method bottema-roth --out screws.csv trial.csv\n";

static const struct method *const least_squares = &methods[METHODS - 1];

enum { AGAINST_FIRST = 0, AGAINST_PREVIOUS = -1 }; /* or the number of a frame */

struct options {
  const char *file;
  const char *markers;
  const char *relative_to;
  long points;
  const struct method *method; /* NULL: all */
  double weights[MOST_CHOSEN];
  int weight_count; /* 0: none given */
  double sigma;     /* negative: not given */
  long against;
  double tolerance;
  bool degrees;
  const char *out;
};

/* A run through the file. The markers chosen are those of the body and behind them those it is seen from. */
struct run {
  const struct options *options;
  struct markers markers;
  int chosen[MOST_CHOSEN];
  int body;
  int all;
  const char *unit;
  FILE *csv; /* NULL: the table is printed */
  bool has_base;
  struct frame base; /* where the second body is thought to stay */
  bool has_reference;
  struct frame reference;
  long frames;
  long missing;
  long solved;
  long failed;
};

enum kind { SOLVED, FAILED, REFERENCE, MISSING };

/* What is printed of a frame. */
struct result {
  enum kind kind;
  const struct frame *frame;
  const struct method *method;
  long against; /* number of the reference frame */
  int status;
  const char *blamed; /* on failure: what of the two frames, or both bodies, is to blame; or "" */
  chs_screw screw;
  double rms;
  double deviations[4]; /* of angle, axis, point and translation; NaN where there is none */
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

/* Adds the markers of a list that has been read before. */
static bool choose_named(struct run *run, const char *names) {
  for (const char *name = names; name != NULL;) {
    name += strspn(name, " ");
    const size_t length = strcspn(name, ",");
    const int found = markers_find(&run->markers, name, length);
    if (found < 0) return unknown_marker(&run->markers, name, length);
    run->chosen[run->all++] = found;
    name = name[length] == ',' ? name + length + 1 : NULL;
  }
  return true;
}

static void choose_first(struct run *run) {
  const int points = (int)run->options->points;
  while (run->all < points) {
    run->chosen[run->all] = run->all;
    ++run->all;
  }
  if (run->markers.count == points) return;
  complain("no --markers given: the first %d are taken of", points);
  print_marker_names(&run->markers);
}

static bool choose_markers(struct run *run) {
  const struct marker *list = run->markers.list;
  const struct options *options = run->options;
  if (run->markers.count < 3 || (options->markers == NULL && run->markers.count < options->points)) {
    const int first = run->markers.has_time && run->markers.columns > 1;
    text_expected(&run->markers.text, run->markers.count == 0 ? run->markers.cells[first] : list[0].name,
                  "columns NAME_x, NAME_y, NAME_z of at least %ld markers",
                  options->markers == NULL ? options->points : 3);
    return false;
  }
  run->all = 0;
  if (options->markers == NULL) {
    choose_first(run);
  } else if (!choose_named(run, options->markers)) {
    return false;
  }
  run->body = run->all;
  if (options->relative_to != NULL && !choose_named(run, options->relative_to)) return false;
  run->unit = list[run->chosen[0]].unit;
  for (int i = 1; i < run->all; ++i) {
    const struct marker *marker = &list[run->chosen[i]];
    if (strcmp(marker->unit, run->unit) == 0) continue;
    text_expected(&run->markers.text, marker->unit, "the unit '%s' of marker %s for %s as well", run->unit,
                  list[run->chosen[0]].name, marker->name);
    return false;
  }
  return true;
}

static int count_present(const struct frame *frame, int from, int to) {
  int count = 0;
  for (int i = from; i < to; ++i) count += frame->present[i];
  return count;
}

static bool is_complete(const struct run *run, const struct frame *frame) {
  return count_present(frame, 0, run->all) == run->all;
}

/* Enough markers for both bodies: all three of three, and three of more where least squares are wanted. */
static bool is_usable(const struct run *run, const struct frame *frame) {
  const bool any_number = run->body > 3;
  const int body = count_present(frame, 0, run->body);
  const int base = count_present(frame, run->body, run->all);
  return (any_number ? body >= 3 : body == run->body) && (run->all == run->body || base >= 3);
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

static bool has_deviations(const struct run *run) { return run->options->sigma >= 0.0; }

static void print_table_titles(const struct run *run) {
  printf("%6s", "frame");
  if (run->markers.has_time) printf(" %10.10s", run->markers.time_title);
  printf(" %6s", "from");
  if (run->options->method == NULL) printf(" %-14s", "method");
  printf(" %10s %8s %8s %8s", "angle_deg", "axis_x", "axis_y", "axis_z");
  print_title(stdout, 11, "point_x", run->unit);
  print_title(stdout, 11, "point_y", run->unit);
  print_title(stdout, 11, "point_z", run->unit);
  print_title(stdout, 13, "translation", run->unit);
  print_title(stdout, 11, "rms", run->unit);
  if (has_deviations(run)) {
    printf(" %12s %11s", "sd_angle_deg", "sd_axis_rad");
    print_title(stdout, 11, "sd_point", run->unit);
    print_title(stdout, 16, "sd_translation", run->unit);
  }
  puts("  status");
}

static void print_csv_titles(const struct run *run) {
  FILE *file = run->csv;
  const char *joint = *run->unit == '\0' ? "" : "_";
  const char *angle = run->options->degrees ? "deg" : "rad";
  fputs("frame,", file);
  if (run->markers.has_time) {
    print_quoted(file, run->markers.time_title);
    fputc(',', file);
  }
  fprintf(file, "from,method,angle_%s,axis_x,axis_y,axis_z,", angle);
  for (int axis = 0; axis < 3; ++axis) fprintf(file, "point_%c%s%s,", "xyz"[axis], joint, run -> unit);
  fprintf(file, "translation%s%s,rms%s%s,", joint, run->unit, joint, run->unit);
  if (has_deviations(run)) {
    fprintf(file, "sd_angle_%s,sd_axis_rad,sd_point%s%s,sd_translation%s%s,", angle, joint, run->unit, joint,
            run->unit);
  }
  fputs("status,note\n", file);
}

static void print_missing(FILE *file, const struct run *run, const struct frame *frame) {
  fputs("missing:", file);
  for (int k = 0; k < run->all; ++k) {
    if (!frame->present[k]) fprintf(file, " %s", run->markers.list[run->chosen[k]].name);
  }
}

/* In words: why there is no screw, or what the library says of it. */
static void print_note(FILE *file, const struct run *run, const struct result *result) {
  switch (result->kind) {
  case REFERENCE: fputs("reference", file); return;
  case MISSING: print_missing(file, run, result->frame); return;
  case FAILED: fputs(result->blamed, file); break;
  case SOLVED: break;
  }
  fputs(chs_status_text(result->status), file);
  if (is_complete(run, result->frame)) return;
  fputs("; ", file);
  print_missing(file, run, result->frame);
}

static bool was_tried(const struct result *result) { return result->kind == SOLVED || result->kind == FAILED; }

static void print_table_row(const struct run *run, const struct result *result) {
  const chs_screw *screw = &result->screw;
  printf("%6ld", result->frame->number);
  if (run->markers.has_time) printf(" %10.6f", result->frame->time);
  if (was_tried(result)) {
    printf(" %6ld", result->against);
  } else {
    printf(" %6s", "");
  }
  if (run->options->method == NULL) printf(" %-14s", was_tried(result) ? result->method->name : "");
  if (result->kind == SOLVED) {
    printf(" %10.5f", in_degrees(screw->angle));
    for (int i = 0; i < 3; ++i) printf(" %8.5f", screw->axis[i]);
    for (int i = 0; i < 3; ++i) printf(" %11.5g", screw->point[i]);
    printf(" %13.5g %11.3g", screw->translation, result->rms);
    const double *sd = result->deviations;
    if (has_deviations(run) && isnan(sd[0])) {
      printf(" %53s", "");
    } else if (has_deviations(run)) {
      printf(" %12.4g %11.3g %11.3g %16.3g", in_degrees(sd[0]), sd[1], sd[2], sd[3]);
    }
  } else {
    printf(" %*s", has_deviations(run) ? 153 : 99, "");
  }
  fputs("  ", stdout);
  print_note(stdout, run, result);
  putchar('\n');
}

static void print_cell(FILE *file, double x) {
  fputc(',', file);
  if (!isnan(x)) print_shortest(file, x);
}

static void print_csv_row(const struct run *run, const struct result *result) {
  FILE *file = run->csv;
  const chs_screw *screw = &result->screw;
  const bool degrees = run->options->degrees;
  const double *sd = result->deviations;
  const double numbers[] = {degrees ? in_degrees(screw->angle) : screw->angle,
                            screw->axis[0],
                            screw->axis[1],
                            screw->axis[2],
                            screw->point[0],
                            screw->point[1],
                            screw->point[2],
                            screw->translation,
                            result->rms,
                            degrees ? in_degrees(sd[0]) : sd[0],
                            sd[1],
                            sd[2],
                            sd[3]};
  fprintf(file, "%ld", result->frame->number);
  if (run->markers.has_time) print_cell(file, result->frame->time);
  fputc(',', file);
  if (was_tried(result)) fprintf(file, "%ld", result->against);
  fprintf(file, ",%s", was_tried(result) ? result->method->name : "");
  for (int i = 0; i < (has_deviations(run) ? 13 : 9); ++i)
    print_cell(file, result->kind == SOLVED ? numbers[i] : (double)NAN);
  fputc(',', file);
  if (was_tried(result)) fprintf(file, "%d", result->status);
  fputs(",\"", file);
  print_note(file, run, result);
  fputs("\"\n", file);
}

static void print_names(FILE *file, const struct run *run, int from, int to) {
  for (int i = from; i < to; ++i) {
    fprintf(file, "%s%s", i == from ? "" : ", ", run->markers.list[run->chosen[i]].name);
  }
}

static void print_summary(const struct run *run) {
  FILE *file = run->csv == stdout ? stderr : stdout;
  if (run->csv == NULL) fputc('\n', file);
  print_names(file, run, 0, run->body);
  if (run->all > run->body) fputs(" relative to ", file);
  print_names(file, run, run->body, run->all);
  fprintf(file, " by %s: %ld frames, %ld solved, %ld with a marker missing, %ld in error\n",
          run->options->method == NULL ? "all methods" : run->options->method->name, run->frames, run->solved,
          run->missing, run->failed);
}

/* ---- Solving ---- */

/* Takes the body's markers to where the second body sees them from its place in the base frame. The status of the
 * second body's own displacement. */
static int see_from_base(const struct run *run, struct frame *frame) {
  double T[16];
  double back[16];
  const size_t count = (size_t)(run->all - run->body);
  const size_t offset = 3 * (size_t)run->body;
  if (count == 0) return CHS_OK;
  const int status = chs_motion_fit(count, run->base.points + offset, frame->points + offset, NULL, NULL,
                                    run->options->tolerance, NULL, T, NULL);
  if (status < 0) return status;
  chs_se3_inverse(T, back);
  for (int k = 0; k < run->body; ++k) chs_se3_apply(back, frame->points + 3 * k, frame->points + 3 * k);
  return CHS_OK;
}

static const double *weights_of(const struct run *run) {
  return run->options->weight_count > 0 ? run->options->weights : NULL;
}

static int solve_pair(const struct run *run, const struct method *method, const double *initial, const double *final,
                      chs_screw *screw, double *T) {
  const double tolerance = run->options->tolerance;
  if (method->solve != NULL) return method->solve(initial, final, tolerance, screw, T);
  return chs_motion_fit((size_t)run->body, initial, final, weights_of(run), NULL, tolerance, screw, T, NULL);
}

static double largest_coordinate(const struct run *run, const struct frame *frame) {
  double largest = 0.0;
  for (int i = 0; i < 3 * run->body; ++i) {
    if (frame->present[i / 3] && fabs(frame->points[i]) > largest) largest = fabs(frame->points[i]);
  }
  return largest;
}

/* Which frame is to blame for a failure: one whose markers do not even make a body by themselves; or both, where one is
 * lost beside the other. How large their coordinates are tells whether a stray number is the reason. */
static const char *blame(const struct run *run, const struct result *result, const struct frame *frame) {
  static char text[128];
  const struct frame *frames[] = {&run->reference, frame};
  for (int i = 0; i < 2; ++i) {
    const double *points = frames[i]->points;
    if (solve_pair(run, result->method, points, points, NULL, NULL) >= 0) continue;
    snprintf(text, sizeof text, "%sframe %ld, coordinates up to %g: ", i == 0 ? "the reference, " : "",
             frames[i]->number, largest_coordinate(run, frames[i]));
    return text;
  }
  if (result->status != CHS_ERR_COINCIDENT && result->status != CHS_ERR_COLLINEAR) return "";
  snprintf(text, sizeof text, "frames %ld and %ld beside each other, coordinates up to %g: ", run->reference.number,
           frame->number, fmax(largest_coordinate(run, &run->reference), largest_coordinate(run, frame)));
  return text;
}

static double rms_of(const struct run *run, const double *initial, const struct frame *frame, const double *T) {
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < run->body; ++k) {
    double image[3];
    if (!frame->present[k]) continue;
    chs_se3_apply(T, initial + 3 * k, image);
    for (int i = 0; i < 3; ++i) sum += pow(frame->points[3 * k + i] - image[i], 2);
    ++count;
  }
  return sqrt(sum / count);
}

/* The errors of both frames add up. */
static void find_deviations(const struct run *run, const struct frame *frame, struct result *result) {
  double covariance[64];
  for (int i = 0; i < 4; ++i) result->deviations[i] = (double)NAN;
  if (!has_deviations(run) || result->method->solve != NULL) return;
  const int status = chs_motion_covariance((size_t)run->body, run->reference.points, frame->points, weights_of(run),
                                           NULL, sqrt(2.0) * run->options->sigma, NULL, covariance);
  if (status < 0) return;
  if (result->status == CHS_OK) result->status = status;
  const double *c = covariance;
  result->deviations[0] = sqrt(c[63]);
  result->deviations[1] = sqrt(c[0] + c[9] + c[18]);
  result->deviations[2] = sqrt(c[27] + c[36] + c[45]);
  result->deviations[3] = sqrt(c[54]);
}

static struct result solve_frame(const struct run *run, const struct frame *frame, const struct frame *seen,
                                 int base_status, const struct method *method) {
  struct result result;
  double T[16];
  memset(&result, 0, sizeof result);
  result.frame = frame;
  result.method = method;
  result.blamed = "";
  result.against = run->reference.number;
  if (!is_usable(run, frame) || (!run->has_reference && !is_complete(run, frame))) {
    result.kind = MISSING;
  } else if (!run->has_reference || frame->number == run->reference.number) {
    result.kind = REFERENCE;
  } else if (base_status < 0) {
    result.kind = FAILED;
    result.status = base_status;
    result.blamed = "the body it is relative to: ";
  } else {
    result.status = solve_pair(run, method, run->reference.points, seen->points, &result.screw, T);
    result.kind = result.status < 0 ? FAILED : SOLVED;
    if (result.kind == FAILED) result.blamed = blame(run, &result, seen);
    if (result.kind == SOLVED) result.rms = rms_of(run, run->reference.points, seen, T);
    if (result.kind == SOLVED) find_deviations(run, seen, &result);
  }
  return result;
}

static void print_result(const struct run *run, const struct result *result) {
  if (run->csv == NULL) {
    print_table_row(run, result);
  } else {
    print_csv_row(run, result);
  }
}

/* A line, or one for each method; what became of the frame. */
static enum kind report_frame(const struct run *run, const struct frame *frame, const struct frame *seen,
                              int base_status) {
  const struct method *only = run->options->method;
  enum kind kind = SOLVED;
  for (int i = 0; i < METHODS; ++i) {
    if (only != NULL && only != &methods[i]) continue;
    const struct result result = solve_frame(run, frame, seen, base_status, &methods[i]);
    print_result(run, &result);
    if (result.kind != SOLVED) kind = result.kind;
    if (!was_tried(&result)) break;
  }
  return kind;
}

static void take_frame(struct run *run, const struct frame *frame) {
  struct frame seen = *frame;
  const bool complete = is_complete(run, frame);
  if (!run->has_base && complete) run->base = *frame;
  run->has_base = run->has_base || complete;
  const int base_status = is_usable(run, frame) && run->has_base ? see_from_base(run, &seen) : CHS_OK;
  const enum kind kind = report_frame(run, frame, &seen, base_status);
  ++run->frames;
  if (kind == MISSING) ++run->missing;
  if (kind == SOLVED) ++run->solved;
  if (kind == FAILED) ++run->failed;
  if (!complete || base_status < 0) return;
  if (!run->has_reference || run->options->against == AGAINST_PREVIOUS) run->reference = seen;
  run->has_reference = true;
}

static bool solve_frames(struct run *run) {
  struct frame frame;
  enum text_result read;
  if (run->csv == NULL) {
    print_table_titles(run);
  } else {
    print_csv_titles(run);
  }
  while ((read = markers_next(&run->markers, run->chosen, run->all, &frame)) == TEXT_LINE) take_frame(run, &frame);
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
    read = markers_next(&run->markers, run->chosen, run->all, &run->reference);
  }
  if (read == TEXT_END) {
    complain("%s has no frame %ld: it ends with frame %ld", run->markers.text.name, wanted, run->markers.frame);
  } else if (read == TEXT_LINE && !is_complete(run, &run->reference)) {
    complain("%s:%ld: frame %ld cannot be the reference, a marker is missing in it", run->markers.text.name,
             run->reference.line, wanted);
  } else {
    run->has_reference = run->has_base = read == TEXT_LINE;
    run->base = run->reference;
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

/* Where everything fails against one reference, it is the first to suspect. */
static void suspect_reference(const struct run *run) {
  if (run->solved > 0 || run->failed < 2 || run->options->against == AGAINST_PREVIOUS) return;
  complain("all frames fail against the reference, frame %ld: it may be to blame; try --against another frame",
           run->reference.number);
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
  if (!run.has_reference) complain("no frame has all markers");
  if (run.has_reference) suspect_reference(&run);
  return run.has_reference && run.failed == 0 ? ALL_WELL : SOMETHING_OVER;
}

/* ---- Options ---- */

static bool read_method(const char *name, struct options *options) {
  options->method = find_method(name);
  if (options->method != NULL) return true;
  complain("--method expects least-squares, spoor-veldpaus, laub-shiflett, angeles, beggs or bottema-roth, not '%s'",
           name);
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

static bool read_amount(const char *option, const char *word, double *amount) {
  if (read_number(word, amount) && *amount >= 0.0) return true;
  complain("%s expects a number of at least 0, not '%s'", option, word);
  return false;
}

static bool read_weights(const char *word, struct options *options) {
  options->weight_count = read_number_list(word, options->weights, MOST_CHOSEN);
  bool good = options->weight_count > 0;
  for (int i = 0; i < options->weight_count; ++i) good = good && options->weights[i] >= 0.0;
  if (!good) complain("--weights expects numbers of at least 0, parted by commas, not '%s'", word);
  return good;
}

/* Whether the name stands in the list before it. */
static bool is_repeated(const char *names, const char *name, size_t length) {
  for (const char *other = names + strspn(names, " "); other < name; other += strspn(other, " ")) {
    const size_t other_length = strcspn(other, ",");
    if (other_length == length && strncmp(other, name, length) == 0) return true;
    other += other_length + 1;
  }
  return false;
}

/* How many names, all different, are parted by commas; 0 where some are the same or empty. */
static int count_names(const char *names) {
  int count = 0;
  for (const char *name = names; name != NULL && count < MOST_CHOSEN; ++count) {
    name += strspn(name, " ");
    const size_t length = strcspn(name, ",");
    if (length == 0 || is_repeated(names, name, length)) return 0;
    name = name[length] == ',' ? name + length + 1 : NULL;
  }
  return count;
}

static bool read_markers(const char *option, const char *names, const char **markers) {
  *markers = names;
  const int count = count_names(names);
  if (count >= 3 && count <= MOST_CHOSEN / 2) return true;
  complain("%s expects 3 to %d different names parted by commas, not '%s'", option, MOST_CHOSEN / 2, names);
  return false;
}

static bool read_points(const char *word, struct options *options) {
  if (parse_integer(word, 3, MOST_CHOSEN / 2, &options->points)) return true;
  complain("--points expects a number from 3 to %d, not '%s'", MOST_CHOSEN / 2, word);
  return false;
}

/* What the options say together. */
static bool options_agree(const struct options *options) {
  const int points = options->markers == NULL ? (int)options->points : count_names(options->markers);
  if (points > 3 && (options->method == NULL || options->method->solve != NULL)) {
    complain("%d markers: only --method least-squares takes more than three", points);
  } else if (options->weight_count > 0 && options->weight_count != points) {
    complain("--weights has %d numbers for %d markers", options->weight_count, points);
  } else if (options->weight_count > 0 && options->method != least_squares) {
    complain("--weights needs --method least-squares");
  } else if (options->sigma >= 0.0 && options->method != NULL && options->method->solve != NULL) {
    complain("--covariance needs --method least-squares");
  } else if (options->sigma >= 0.0 && options->relative_to != NULL) {
    complain("--covariance knows the errors of one body and does not go with --relative-to");
  } else if (options->against > 0 && strcmp(options->file, "-") == 0) {
    complain("--against a frame's number reads the file twice, which standard input does not allow");
  } else {
    return true;
  }
  return false;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"markers", required_argument, NULL, 'k'},
                                        {"points", required_argument, NULL, 'p'},
                                        {"against", required_argument, NULL, 'a'},
                                        {"relative-to", required_argument, NULL, 'r'},
                                        {"method", required_argument, NULL, 'm'},
                                        {"all-methods", no_argument, NULL, 'l'},
                                        {"weights", required_argument, NULL, 'w'},
                                        {"covariance", required_argument, NULL, 'c'},
                                        {"tolerance", required_argument, NULL, 't'},
                                        {"degrees", no_argument, NULL, 'd'},
                                        {"out", required_argument, NULL, 'o'},
                                        {"help", no_argument, NULL, 'h'},
                                        {NULL, 0, NULL, 0}};
  bool good = true;
  int option;
  while (good && (option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'k': good = read_markers("--markers", optarg, &options->markers); break;
    case 'p': good = read_points(optarg, options); break;
    case 'r': good = read_markers("--relative-to", optarg, &options->relative_to); break;
    case 'a': good = read_against(optarg, options); break;
    case 'm': good = read_method(optarg, options); break;
    case 'l': options->method = NULL; break;
    case 'w': good = read_weights(optarg, options); break;
    case 'c': good = read_amount("--covariance", optarg, &options->sigma); break;
    case 't': good = read_amount("--tolerance", optarg, &options->tolerance); break;
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
  return options_agree(options) ? -1 : UNUSABLE;
}

int solve_command(int argc, char **argv) {
  struct options options;
  memset(&options, 0, sizeof options);
  options.points = 3;
  options.method = least_squares;
  options.sigma = -1.0;
  options.against = AGAINST_FIRST;
  options.tolerance = 0.05;
  const int status = read_options(argc, argv, &options);
  return status == -1 ? solve(&options) : status;
}
