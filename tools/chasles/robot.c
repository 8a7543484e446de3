/* robot.c - see robot.h. */
#include "robot.h"

#include <chasles/chasles.h>
#include <math.h>
#include <string.h>

#include "angles.h"
#include "text.h"

enum { LONGEST_LINE = 1000, MOST_NUMBERS = 16 };

enum rows { NO_ROWS, SCREWS, DH_STANDARD, DH_MODIFIED };

/* A file being read. */
struct reading {
  struct text text;
  struct robot *robot;
  enum rows rows;
  unsigned seen; /* bit i: keyword i of the table below was there */
  bool has_angles;
  bool has_home;
  double dh[4 * MOST_JOINTS]; /* with base and tool, in place of screws and home */
  double base[16];
  double tool[16];
};

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* ---- Words ---- */

static bool expected(const struct reading *reading, const char *found, const char *what) {
  text_expected(&reading->text, found == NULL ? "" : found, "%s", what);
  return false;
}

static bool next_number(const struct reading *reading, const char *word, double *x) {
  return (word != NULL && read_number(word, x)) || expected(reading, word, "a number with a decimal point");
}

static bool next_numbers(const struct reading *reading, char **line, int count, double *x) {
  for (int i = 0; i < count; ++i) {
    if (!next_number(reading, next_word(line), &x[i])) return false;
  }
  return true;
}

static bool read_end(const struct reading *reading, char **line) {
  const char *word = next_word(line);
  return word == NULL || expected(reading, word, "nothing more on this line");
}

static double angle_of(const struct robot *robot, double written) {
  return robot->degrees ? in_radians(written) : written;
}

/* The rest of the line as a text that fits. */
static bool read_name(const struct reading *reading, char *line, char *name, size_t size) {
  line += strspn(line, " \t");
  size_t length = strlen(line);
  while (length > 0 && (line[length - 1] == ' ' || line[length - 1] == '\t')) --length;
  if (length == 0) return expected(reading, "", "a name");
  if (length >= size) {
    text_expected(&reading->text, line, "at most %zu characters", size - 1);
    return false;
  }
  memcpy(name, line, length);
  name[length] = '\0';
  return true;
}

/* Three numbers, a position, or twelve, the rows of [R p]. */
static bool read_pose(const struct reading *reading, char *line, double T[16]) {
  double numbers[MOST_NUMBERS];
  int count = 0;
  for (const char *word; (word = next_word(&line)) != NULL; ++count) {
    if (count == 12) return expected(reading, word, "nothing more on this line");
    if (!next_number(reading, word, &numbers[count])) return false;
  }
  if (count != 3 && count != 12) return expected(reading, "", "3 or 12 numbers of a pose");
  memcpy(T, identity, sizeof identity);
  if (count == 12) memcpy(T, numbers, 12 * sizeof *T);
  for (int i = 0; i < 3 && count == 3; ++i) T[4 * i + 3] = numbers[i];
  const double R[9] = {T[0], T[1], T[2], T[4], T[5], T[6], T[8], T[9], T[10]};
  const int status = chs_so3_check(R, CHS_SO3_FAR);
  if (status < 0) {
    text_expected(&reading->text, chs_status_text(status), "a pose");
    return false;
  }
  return true;
}

/* ---- Joints ---- */

static void add_dh_row(struct reading *reading, const double row[4]) {
  double *dh = reading->dh + 4 * reading->robot->joints;
  for (int i = 0; i < 4; ++i) dh[i] = i % 2 == 0 ? row[i] : angle_of(reading->robot, row[i]);
}

static bool add_screw_row(struct reading *reading, const char *type, const double *row) {
  double *S = reading->robot->screws + 6 * reading->robot->joints;
  const int status = strcmp(type, "prismatic") == 0  ? chs_screw_prismatic(row, S)
                     : strcmp(type, "revolute") == 0 ? chs_screw_revolute(row + 3, row, S)
                                                     : chs_screw_helical(row + 3, row, row[6], S);
  reading->robot->pitch[reading->robot->joints] = strcmp(type, "helical") == 0 ? row[6] : 0.0;
  return status >= 0 || expected(reading, "0 0 0", "the direction of an axis");
}

static int numbers_of_row(enum rows rows, const char *type) {
  if (rows != SCREWS) return 4;
  return strcmp(type, "prismatic") == 0 ? 3 : strcmp(type, "revolute") == 0 ? 6 : 7;
}

/* "limits LEAST GREATEST" or nothing. */
static bool read_limits(struct reading *reading, char *line) {
  struct robot *robot = reading->robot;
  double *limits = robot->limits + 2 * robot->joints;
  limits[0] = -(double)INFINITY;
  limits[1] = (double)INFINITY;
  const char *word = next_word(&line);
  if (word == NULL) return true;
  if (strcmp(word, "limits") != 0) return expected(reading, word, "'limits' or the end of the line");
  const char *first = line + strspn(line, " \t");
  if (!next_numbers(reading, &line, 2, limits) || !read_end(reading, &line)) return false;
  if (limits[0] > limits[1]) return expected(reading, first, "the lower limit first");
  for (int i = 0; i < 2; ++i) limits[i] = robot_value(robot, robot->joints, limits[i]);
  return true;
}

static bool read_joint(struct reading *reading, const char *type, char *line) {
  struct robot *robot = reading->robot;
  double row[MOST_NUMBERS];
  if (!reading->has_angles) return expected(reading, type, "'angles degrees' or 'angles radians' before the joints");
  if (reading->rows == NO_ROWS)
    return expected(reading, type, "'rows screws', 'rows dh-standard' or 'rows dh-modified' first");
  if (reading->rows != SCREWS && strcmp(type, "helical") == 0)
    return expected(reading, type, "a revolute or prismatic joint");
  if (robot->joints == MOST_JOINTS) {
    text_expected(&reading->text, type, "at most %d joints", (int)MOST_JOINTS);
    return false;
  }
  const bool turns = strcmp(type, "prismatic") != 0;
  robot->turns[robot->joints] = turns;
  if (!next_numbers(reading, &line, numbers_of_row(reading->rows, type), row)) return false;
  if (reading->rows != SCREWS) add_dh_row(reading, row);
  if (reading->rows == SCREWS && !add_screw_row(reading, type, row)) return false;
  if (!read_limits(reading, line)) return false;
  ++robot->joints;
  return true;
}

/* ---- Lines ---- */

static bool read_robot(struct reading *reading, char *line) {
  return read_name(reading, line, reading->robot->name, sizeof reading->robot->name);
}

static bool read_lengths(struct reading *reading, char *line) {
  return read_name(reading, line, reading->robot->unit, sizeof reading->robot->unit);
}

static bool read_angles(struct reading *reading, char *line) {
  const char *word = next_word(&line);
  const bool degrees = word != NULL && strcmp(word, "degrees") == 0;
  if (!degrees && (word == NULL || strcmp(word, "radians") != 0)) return expected(reading, word, "degrees or radians");
  reading->robot->degrees = degrees;
  reading->has_angles = true;
  return read_end(reading, &line);
}

static bool read_rows(struct reading *reading, char *line) {
  static const char *const names[] = {"screws", "dh-standard", "dh-modified"};
  const char *word = next_word(&line);
  for (int i = 0; i < 3 && word != NULL; ++i) {
    if (strcmp(word, names[i]) != 0) continue;
    reading->rows = (enum rows)(SCREWS + i);
    return read_end(reading, &line);
  }
  return expected(reading, word, "screws, dh-standard or dh-modified");
}

static bool read_home(struct reading *reading, char *line) {
  if (reading->rows != SCREWS) return expected(reading, "home", "'home' behind 'rows screws' only");
  reading->has_home = true;
  return read_pose(reading, line, reading->robot->home);
}

static bool read_base(struct reading *reading, char *line) {
  if (reading->rows < DH_STANDARD)
    return expected(reading, "base", "'base' behind 'rows dh-standard' or 'rows dh-modified' only");
  return read_pose(reading, line, reading->base);
}

static bool read_tool(struct reading *reading, char *line) {
  if (reading->rows < DH_STANDARD)
    return expected(reading, "tool", "'tool' behind 'rows dh-standard' or 'rows dh-modified' only");
  return read_pose(reading, line, reading->tool);
}

static bool is_joint(const char *word) {
  return strcmp(word, "revolute") == 0 || strcmp(word, "prismatic") == 0 || strcmp(word, "helical") == 0;
}

static const struct {
  const char *word;
  bool (*read)(struct reading *reading, char *line);
} keywords[] = {{"robot", read_robot}, {"angles", read_angles}, {"lengths", read_lengths}, {"rows", read_rows},
                {"home", read_home},   {"base", read_base},     {"tool", read_tool}};

/* Each keyword but once: a second `rows` would leave the joints before it unread, a second `home` the first. */
static bool read_line(struct reading *reading, char *line) {
  line[strcspn(line, "#")] = '\0';
  const char *word = next_word(&line);
  if (word == NULL) return true;
  if (is_joint(word)) return read_joint(reading, word, line);
  for (size_t i = 0; i < sizeof keywords / sizeof *keywords; ++i) {
    if (strcmp(word, keywords[i].word) != 0) continue;
    if ((reading->seen >> i & 1U) != 0) {
      text_expected(&reading->text, word, "no second '%s'", word);
      return false;
    }
    reading->seen |= 1U << i;
    return keywords[i].read(reading, line);
  }
  return expected(reading, word, "robot, angles, lengths, rows, revolute, prismatic, helical, home, base or tool");
}

/* What is one or zero but for rounding, as after a turn by 90 degrees, is one or zero. */
static void tidy(double *x, int count) {
  for (int i = 0; i < count; ++i) {
    const double whole = floor(x[i] + 0.5);
    if (fabs(x[i] - whole) < 0x1p-50) x[i] = whole;
  }
}

/* Screws and the pose at zero from the rows of Denavit and Hartenberg. */
static bool convert_dh(struct reading *reading) {
  struct robot *robot = reading->robot;
  double axes[6 * MOST_JOINTS];
  const chs_dh convention = reading->rows == DH_STANDARD ? CHS_DH_STANDARD : CHS_DH_MODIFIED;
  const int status =
      chs_line_from_dh(robot->joints, convention, reading->base, reading->dh, reading->tool, axes, robot->home);
  if (status < 0) {
    text_expected(&reading->text, NULL, "rows of Denavit and Hartenberg that give a robot: %s",
                  chs_status_text(status));
    return false;
  }
  for (int i = 0; i < 3; ++i) tidy(robot->home + 4 * i, 3);
  for (int i = 0; i < robot->joints; ++i) {
    const double *axis = axes + 6 * i;
    double *S = robot->screws + 6 * i;
    tidy(axes + 6 * i, 3);
    for (int k = 0; k < 3; ++k) {
      S[k] = robot->turns[i] ? axis[k] : 0.0;
      S[3 + k] = robot->turns[i] ? axis[3 + k] : axis[k];
    }
  }
  return true;
}

/* What a whole file must have. */
static bool finish(struct reading *reading) {
  struct robot *robot = reading->robot;
  if (robot->joints == 0) text_expected(&reading->text, NULL, "a joint");
  if (robot->joints > 0 && reading->rows == SCREWS && !reading->has_home) text_expected(&reading->text, NULL, "'home'");
  if (robot->joints == 0 || (reading->rows == SCREWS && !reading->has_home)) return false;
  return reading->rows == SCREWS || convert_dh(reading);
}

bool robot_read(struct robot *robot, const char *name) {
  struct reading reading;
  memset(&reading, 0, sizeof reading);
  memset(robot, 0, sizeof *robot);
  memcpy(robot->name, "unnamed", sizeof "unnamed");
  reading.robot = robot;
  memcpy(reading.base, identity, sizeof identity);
  memcpy(reading.tool, identity, sizeof identity);
  if (!text_open(&reading.text, name, LONGEST_LINE)) return false;
  enum text_result result;
  while ((result = text_next(&reading.text)) == TEXT_LINE) {
    if (!read_line(&reading, reading.text.buffer)) break;
  }
  const bool good = result == TEXT_END && finish(&reading);
  text_close(&reading.text);
  return good;
}

/* ---- The robot ---- */

chs_chain robot_chain(const struct robot *robot) {
  chs_chain chain = {robot->joints, CHS_SPACE_FORM, robot->screws, {0}, robot->limits};
  memcpy(chain.home, robot->home, sizeof chain.home);
  return chain;
}

double robot_value(const struct robot *robot, int joint, double written) {
  return robot->turns[joint] ? angle_of(robot, written) : written;
}

double robot_written(const struct robot *robot, int joint, double value) {
  return robot->turns[joint] && robot->degrees ? in_degrees(value) : value;
}

bool no_options(int count, char **words) {
  for (int i = 0; i < count; ++i) {
    if (strncmp(words[i], "--", 2) != 0) continue;
    complain("options stand before the file of the robot, and '%s' behind it", words[i]);
    return false;
  }
  return true;
}

bool robot_values(const struct robot *robot, int count, char **words, double *q) {
  if (!no_options(count, words)) return false;
  if (count != robot->joints) {
    complain("%s has %d joint%s, and %d values are given", robot->name, robot->joints, robot->joints == 1 ? "" : "s",
             count);
    return false;
  }
  for (int i = 0; i < count; ++i) {
    double written = 0.0;
    if (!read_number(words[i], &written)) {
      complain("expected a number as value of joint %d, not '%s'", i + 1, words[i]);
      return false;
    }
    q[i] = robot_value(robot, i, written);
  }
  return true;
}

void print_value(double x, int width, bool exact) {
  if (exact) {
    print_shortest(stdout, x + 0.0);
  } else {
    printf("%*.9f", width, fabs(x) < 0.5e-9 ? 0.0 : x);
  }
}

void print_matrix(const double *matrix, int rows, int columns, bool exact) {
  for (int i = 0; i < rows * columns; ++i) {
    if (!exact || i % columns > 0) putchar(' ');
    print_value(matrix[i], 15, exact);
    if (i % columns == columns - 1) putchar('\n');
  }
}

void print_pose(const double T[16], bool exact) { print_matrix(T, 3, 4, exact); }
