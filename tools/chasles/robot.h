/* robot.h - robots as text: a serial chain, read from a file.
 *
 *   # the arm of chapter 4; everything after a # is a comment
 *   robot Example               a name; may be left out, as may the unit and limits
 *   angles degrees              or radians: of this file, and of joint values typed and printed
 *   lengths m                   any unit; all lengths are of this one
 *   rows screws                 what the rows of joints are; see below
 *   revolute 0 0 1  0 0 0       limits -180 180
 *   prismatic 0 0 -1            limits 0 0.2
 *   home 0.5 0 0.3              the tool's pose at zero: its position, or twelve numbers, the rows of [R p]
 *
 * Rows of `screws`, from the fixed end on:
 *
 *   revolute  direction of the axis (3), a point of it (3)
 *   helical   the same, and the pitch, a length a radian
 *   prismatic direction of travel (3)
 *
 * Rows of `dh-standard` and `dh-modified` are Denavit and Hartenberg's four numbers, a alpha d theta, of the distal
 * convention, A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i), and of Craig's, A_i = Rx(alpha) Tx(a) Rz(theta) Tz(d) with
 * a and alpha of the link before. The joint value adds to theta of a revolute joint and to d of a prismatic one. In
 * place of `home` there may be `base` and `tool`, poses of the first frame and of the tool in the last. `angles` and
 * `rows` stand before the joints, and each keyword but those of joints only once.
 */
#ifndef ROBOT_H
#define ROBOT_H

#include <chasles/chain.h>
#include <stdbool.h>

enum { MOST_JOINTS = 32 };

struct robot {
  char name[64];
  char unit[16]; /* of lengths */
  bool degrees;
  int joints;
  bool turns[MOST_JOINTS];        /* whether the joint value is an angle */
  double pitch[MOST_JOINTS];      /* of a helical joint, otherwise 0 */
  double screws[6 * MOST_JOINTS]; /* in the space form */
  double home[16];
  double limits[2 * MOST_JOINTS]; /* in radians; infinite where the file has none */
};

/* Reads the file; false after a message that names it and the line. */
bool robot_read(struct robot *robot, const char *name);

/* The robot as the library takes it; it points into the robot. */
chs_chain robot_chain(const struct robot *robot);

/* A joint value as people write it to what the library takes, and back. */
double robot_value(const struct robot *robot, int joint, double written);
double robot_written(const struct robot *robot, int joint, double value);

/* Whether none of the words is an option; false after a message. */
bool no_options(int count, char **words);

/* Joint values from words, one a joint; false after a message. */
bool robot_values(const struct robot *robot, int count, char **words, double *q);

/* A number with nine decimals, or with all its digits; without the sign of a negative zero. */
void print_value(double x, int width, bool exact);

/* A row-major matrix, in columns or with all its digits; and the rows of [R p]. */
void print_matrix(const double *matrix, int rows, int columns, bool exact);
void print_pose(const double T[16], bool exact);

#endif
