/* random_inputs.cpp - see random_inputs.hpp. */
#include "random_inputs.hpp"

#include <array>
#include <cmath>
#include <random>

#include "scenes.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

class generator {
public:
  generator(bool single, angles set, std::uint64_t seed) : single_(single), set_(set), engine_(seed) {}

  /* Appends the inputs of one letter. */
  void append(char letter, std::vector<double> &in);

private:
  using vector = std::array<double, 3>;
  using matrix = std::array<double, 9>;

  /* Our own, because the standard's distributions differ from one library to the next. */
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  double small() { return std::pow(10.0, uniform(single_ ? -6.0 : -12.0, -2.0)); }

  double angle() {
    const unsigned choice = static_cast<unsigned>(engine_() >> 62);
    if (set_ == angles::beyond) return uniform(pi, 20.0);
    if (set_ == angles::mixed && choice == 0) return small();
    if (set_ == angles::mixed && choice == 1) return pi - small();
    return uniform(0.0, pi);
  }

  vector cube() { return {uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0)}; }

  vector axis() {
    for (;;) {
      vector e = cube();
      const double n = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
      if (n < 0.1 || n > 1.0) continue;
      for (double &x : e) x /= n;
      return e;
    }
  }

  vector rotation_vector() {
    vector w = axis();
    const double theta = angle();
    for (double &x : w) x *= theta;
    return w;
  }

  /* Rodrigues in long double, so that it is a rotation to the last digit of either precision. */
  static matrix rotation(const vector &w) {
    const long double x = w[0], y = w[1], z = w[2], tt = x * x + y * y + z * z, t = std::sqrt(tt);
    const long double s = t > 0 ? std::sin(t / 2) / t : 0.5L, a = t > 0 ? std::sin(t) / t : 1.0L, b = 2 * s * s;
    const auto d = [](long double v) { return static_cast<double>(v); };
    return {d(1 - b * (y * y + z * z)), d(b * x * y - a * z),       d(b * x * z + a * y),
            d(b * x * y + a * z),       d(1 - b * (x * x + z * z)), d(b * y * z - a * x),
            d(b * x * z - a * y),       d(b * y * z + a * x),       d(1 - b * (x * x + y * y))};
  }

  /* Evenly distributed orientations would need more; these only have to be general. */
  matrix any_rotation() {
    vector w = axis();
    const double theta = uniform(0.0, pi);
    for (double &x : w) x *= theta;
    return rotation(w);
  }

  static matrix product(const matrix &A, const matrix &B) {
    matrix C{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) C[3 * i + j] += A[3 * i + k] * B[3 * k + j];
    return C;
  }

  void put(std::vector<double> &in, double x) const {
    in.push_back(single_ ? static_cast<double>(static_cast<float>(x)) : x);
  }
  template <class Block> void put_all(std::vector<double> &in, const Block &block) const {
    for (const double x : block) put(in, x);
  }

  void put_pose(std::vector<double> &in, const matrix &R, const vector &p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) put(in, R[3 * i + j]);
      put(in, p[i]);
    }
    put_all(in, std::array<double, 4>{0.0, 0.0, 0.0, 1.0});
  }

  std::array<double, scene_joints> joint_angles() {
    std::array<double, scene_joints> q{};
    for (double &x : q) x = uniform(-pi, pi);
    return q;
  }

  /* The tool's pose at these joint angles. */
  void put_goal(std::vector<double> &in, const std::array<double, scene_joints> &q) const {
    matrix R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    vector p{};
    for (std::size_t i = 0; i < scene_joints; ++i) {
      R = product(R, rotation({0.0, 0.0, q[i]}));
      for (std::size_t k = 0; k < 3; ++k) p[k] += R[3 * k] * scene_arm[i].a + R[3 * k + 2] * scene_arm[i].d;
      R = product(R, rotation({scene_arm[i].quarter_turns * pi / 2, 0.0, 0.0}));
    }
    put_pose(in, R, p);
  }

  /* Points of a body before and after a motion. */
  void put_clouds(std::vector<double> &in, int points) {
    const matrix R = rotation(rotation_vector());
    const vector p = cube();
    std::vector<vector> before, after;
    for (int i = 0; i < points; ++i) {
      const vector x = cube();
      vector y = p;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j) y[k] += R[3 * k + j] * x[j];
      before.push_back(x);
      after.push_back(y);
    }
    for (const vector &x : before) put_all(in, x);
    for (const vector &x : after) put_all(in, x);
  }

  bool single_;
  angles set_;
  std::mt19937_64 engine_;
};

void generator::append(char letter, std::vector<double> &in) {
  switch (letter) {
  case 'x': put_all(in, cube()); break;
  case 'w': put_all(in, rotation_vector()); break;
  case 'a': put(in, engine_() >> 63 ? angle() : -angle()); break;
  case 'M': {
    matrix M = any_rotation();
    for (double &x : M) x += uniform(-0.01, 0.01);
    put_all(in, M);
    break;
  }
  case 'R': put_all(in, rotation(rotation_vector())); break;
  case 'Q': {
    const matrix R = any_rotation();
    put_all(in, R);
    put_all(in, product(R, rotation(rotation_vector())));
    break;
  }
  case 'T': {
    const vector w = rotation_vector();
    put_pose(in, rotation(w), cube());
    break;
  }
  case 'V': {
    put_all(in, rotation_vector());
    put_all(in, cube());
    break;
  }
  case 'S': {
    put_all(in, axis());
    put_all(in, cube());
    put(in, uniform(-1.0, 1.0));
    put(in, angle());
    break;
  }
  case 'P': put_clouds(in, 3); break;
  case 't': put(in, 1e-3); break;
  case scene_cloud: put_clouds(in, scene_points); break;
  case scene_angles: put_all(in, joint_angles()); break;
  case scene_goal: {
    std::array<double, scene_joints> q = joint_angles();
    /* Elbow and wrist bent, so that Newton's method arrives. */
    while (std::fabs(std::sin(q[2])) < 0.3 || std::fabs(std::sin(q[4])) < 0.3) q = joint_angles();
    put_goal(in, q);
    for (const double x : q) put(in, x + uniform(-0.2, 0.2));
    break;
  }
  default: break;
  }
}

} // namespace

const char *angles_name(angles set) {
  switch (set) {
  case angles::ordinary: return "ordinary";
  case angles::mixed: return "mixed";
  default: return "beyond";
  }
}

bool has_random_inputs(const std::string &kinds) {
  return kinds.find_first_not_of("xwaMRQTVSPt123") == std::string::npos;
}

bool angles_are_given(const std::string &kinds) { return kinds.find_first_of("waVS") == 0; }

std::vector<double> random_inputs(const std::string &kinds, bool single, angles set, int cases, std::uint64_t seed) {
  generator source(single, set, seed);
  std::vector<double> in;
  for (int i = 0; i < cases; ++i)
    for (const char letter : kinds) source.append(letter, in);
  return in;
}
