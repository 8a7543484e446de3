/* scenes.hpp - what the benchmark runs beside the single functions: a robot, a cloud of points. */
#ifndef SCENES_HPP
#define SCENES_HPP

/* Kinds of inputs beside the letters of functions.def. */
constexpr char scene_cloud = '1';  /* scene_points points before and after a motion */
constexpr char scene_angles = '2'; /* of the arm's joints */
constexpr char scene_goal = '3';   /* a pose of the arm's tool, and joint angles within 0.2 rad of it */

constexpr int scene_points = 100;
constexpr int cloud_thousands = 2048; /* of 1024 points */

/* The arm: a UR5 by the maker's Denavit-Hartenberg parameters (Universal Robots, "DH parameters for calculations of
 * kinematics and dynamics"): Rz(q) Tz(d) Tx(a) Rx(alpha), joint after joint. Metres, and quarter turns for alpha. */
constexpr int scene_joints = 6;
struct joint {
  double a;
  double d;
  int quarter_turns;
};
constexpr joint scene_arm[scene_joints] = {{0.0, 0.089159, 1}, {-0.425, 0.0, 0},   {-0.39225, 0.0, 0},
                                           {0.0, 0.10915, 1},  {0.0, 0.09465, -1}, {0.0, 0.0823, 0}};

#endif
