/* scenes.cpp - chasles in the scenes of scenes.def. */
#include "scenes.hpp"

#include <chasles/chasles.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "library.hpp"

namespace {

/* The library's functions and types by precision. */
template <class Real> struct chs;

template <> struct chs<double> {
  using chain = chs_chain;
  using ik_options = chs_ik;
  static constexpr auto fk = chs_chain_fk;
  static constexpr auto space_jacobian = chs_chain_space_jacobian;
  static constexpr auto body_jacobian = chs_chain_body_jacobian;
  static constexpr auto rates = chs_chain_rates_inverse;
  static constexpr auto inverse = chs_se3_inverse;
  static constexpr auto compose = chs_se3_compose;
  static constexpr auto log = chs_se3_log;
  static constexpr auto ik = chs_chain_ik;
  static constexpr auto ik_step = chs_chain_ik_step;
  static constexpr auto bottema_roth = chs_motion_bottema_roth;
  static constexpr auto laub_shiflett = chs_motion_laub_shiflett;
  static constexpr auto spoor_veldpaus = chs_motion_spoor_veldpaus;
  static constexpr auto angeles = chs_motion_angeles;
  static constexpr auto beggs = chs_motion_beggs;
  static constexpr auto fit = chs_motion_fit;
};

template <> struct chs<float> {
  using chain = chs_chainf;
  using ik_options = chs_ikf;
  static constexpr auto fk = chs_chain_fkf;
  static constexpr auto space_jacobian = chs_chain_space_jacobianf;
  static constexpr auto body_jacobian = chs_chain_body_jacobianf;
  static constexpr auto rates = chs_chain_rates_inversef;
  static constexpr auto inverse = chs_se3_inversef;
  static constexpr auto compose = chs_se3_composef;
  static constexpr auto log = chs_se3_logf;
  static constexpr auto ik = chs_chain_ikf;
  static constexpr auto ik_step = chs_chain_ik_stepf;
  static constexpr auto bottema_roth = chs_motion_bottema_rothf;
  static constexpr auto laub_shiflett = chs_motion_laub_shiflettf;
  static constexpr auto spoor_veldpaus = chs_motion_spoor_veldpausf;
  static constexpr auto angeles = chs_motion_angelesf;
  static constexpr auto beggs = chs_motion_beggsf;
  static constexpr auto fit = chs_motion_fitf;
};

/* The arm of scenes.hpp, its screws given in the fixed frame. All its links being along or across each other at q = 0,
 * every number is exact but for the sums of lengths. */
template <class Real> class arm {
public:
  arm() : chain_() {
    double R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    double p[3] = {0, 0, 0};
    for (int i = 0; i < scene_joints; ++i) {
      const double z[3] = {R[2], R[5], R[8]};
      const double v[3] = {p[1] * z[2] - p[2] * z[1], p[2] * z[0] - p[0] * z[2], p[0] * z[1] - p[1] * z[0]};
      for (int k = 0; k < 3; ++k) {
        screws_[6 * i + k] = static_cast<Real>(z[k]);
        screws_[6 * i + 3 + k] = static_cast<Real>(v[k]);
        p[k] += R[3 * k] * scene_arm[i].a + z[k] * scene_arm[i].d;
        /* Rx by a quarter turn: y becomes z, z becomes -y. */
        const double y = R[3 * k + 1];
        const int turn = scene_arm[i].quarter_turns;
        R[3 * k + 1] = turn == 0 ? y : turn * z[k];
        R[3 * k + 2] = turn == 0 ? z[k] : -turn * y;
      }
    }
    chain_.joints = scene_joints;
    chain_.form = CHS_SPACE_FORM;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) chain_.home[4 * i + j] = static_cast<Real>(R[3 * i + j]);
      chain_.home[4 * i + 3] = static_cast<Real>(p[i]);
    }
    chain_.home[15] = 1;
  }

  const typename chs<Real>::chain &chain() {
    chain_.screws = screws_;
    return chain_;
  }

private:
  typename chs<Real>::chain chain_;
  Real screws_[6 * scene_joints];
};

template <class Real> const typename chs<Real>::chain &ur5() {
  static arm<Real> only;
  return only.chain();
}

/* q <- q + J^-1 log(T^-1 goal), all in the tool's frame; how far it was is left in error. */
template <class Real> void newton_step(const Real *goal, Real *q, Real error[6]) {
  Real J[36], T[16], back[16], rates[6];
  chs<Real>::body_jacobian(&ur5<Real>(), q, J, T);
  chs<Real>::inverse(T, back);
  chs<Real>::compose(back, goal, back);
  chs<Real>::log(back, error);
  if (chs<Real>::rates(J, error, rates) < 0) return;
  for (int i = 0; i < scene_joints; ++i) q[i] += rates[i];
}

/* A method for three points, asked for the pose alone. */
template <class Real, class Method> void add_pose(library &library, const char *name, Method method) {
  using triangle = std::array<Real, 9>;
  using pose = std::array<Real, 16>;
  add<Real, pose, triangle, triangle>(library, name, [method](const triangle &before, const triangle &after, pose &T) {
    method(before.data(), after.data(), Real(1e-3), nullptr, T.data());
  });
}

template <class Real> void describe_precision(library &library) {
  using angles = std::array<Real, scene_joints>;
  using pose = std::array<Real, 16>;
  using cloud = std::array<Real, 3 * scene_points>;
  using jacobian_and_pose = std::array<Real, 36 + 16>;
  add_pose<Real>(library, "pose_bottema_roth", chs<Real>::bottema_roth);
  add_pose<Real>(library, "pose_laub_shiflett", chs<Real>::laub_shiflett);
  add_pose<Real>(library, "pose_spoor_veldpaus", chs<Real>::spoor_veldpaus);
  add_pose<Real>(library, "pose_angeles", chs<Real>::angeles);
  add_pose<Real>(library, "pose_beggs", chs<Real>::beggs);
  add<Real, pose, cloud, cloud>(library, "points_100", [](const cloud &before, const cloud &after, pose &T) {
    constexpr Real any = std::numeric_limits<Real>::infinity();
    chs<Real>::fit(scene_points, before.data(), after.data(), nullptr, nullptr, any, nullptr, T.data(), nullptr);
  });
  add<Real, pose, angles>(library, "ur5_fk",
                          [](const angles &q, pose &T) { chs<Real>::fk(&ur5<Real>(), q.data(), T.data()); });
  add<Real, jacobian_and_pose, angles>(library, "ur5_fk_jacobian", [](const angles &q, jacobian_and_pose &out) {
    chs<Real>::space_jacobian(&ur5<Real>(), q.data(), out.data(), out.data() + 36);
  });
  add<Real, angles, pose, angles>(library, "ur5_newton_step", [](const pose &goal, const angles &start, angles &q) {
    Real error[6];
    q = start;
    newton_step(goal.data(), q.data(), error);
  });
  constexpr Real enough = sizeof(Real) == sizeof(float) ? Real(1e-5) : Real(1e-10);
  static constexpr typename chs<Real>::ik_options options = {CHS_IK_NEWTON, enough, enough, Real(0.1), 50, 0};
  add<Real, angles, pose, angles>(library, "ur5_ik_step", [](const pose &goal, const angles &start, angles &q) {
    Real scratch[CHS_CHAIN_IK_SCRATCH(scene_joints)];
    chs<Real>::ik_step(&ur5<Real>(), goal.data(), start.data(), &options, scratch, q.data(), nullptr);
  });
  add<Real, angles, pose, angles>(library, "ur5_ik", [](const pose &goal, const angles &start, angles &q) {
    Real scratch[CHS_CHAIN_IK_SCRATCH(scene_joints)];
    chs<Real>::ik(&ur5<Real>(), goal.data(), start.data(), &options, scratch, q.data(), nullptr);
  });
}

/* Room for what an array form gives beside the outputs that are looked at. */
template <class Type> Type *room(std::size_t count) {
  static std::vector<Type> memory;
  memory.resize(count);
  return memory.data();
}

/* An array form: one call for all cases, which lie as in functions.def. */
template <class Real> class array_task final : public task {
public:
  using call = void (*)(std::size_t cases, const Real *in, Real *out);
  array_task(call call, int inputs, int outputs) : call_(call), inputs_(inputs), outputs_(outputs) {}
  void load(const double *in, int stride, int cases) override {
    cases_ = static_cast<std::size_t>(cases);
    in_.clear();
    for (int i = 0; i < cases; ++i) in_.insert(in_.end(), in + i * stride, in + i * stride + inputs_);
    out_.resize(cases_ * static_cast<std::size_t>(outputs_));
  }
  void run() override { call_(cases_, in_.data(), out_.data()); }
  void store(double *out, int stride) const override {
    for (std::size_t i = 0; i < cases_; ++i, out += stride)
      std::copy_n(out_.begin() + static_cast<std::ptrdiff_t>(i) * outputs_, outputs_, out);
  }

private:
  call call_;
  int inputs_;
  int outputs_;
  std::size_t cases_ = 0;
  std::vector<Real> in_;
  std::vector<Real> out_;
};

template <class Real>
void add_array(library &library, const char *name, int inputs, int outputs, typename array_task<Real>::call call,
               int first_output = 0) {
  library.entries.push_back({name, sizeof(Real) == sizeof(float), first_output, outputs,
                             [=] { return std::make_unique<array_task<Real> >(call, inputs, outputs); }, ""});
}

/* A cloud made of the cases' points, as often as asked, moved by the first case's pose or merely copied. */
template <class Real> class cloud_task final : public task {
public:
  using call = void (*)(std::size_t points, const Real *pose, const Real *x, Real *y);
  cloud_task(call call, int times) : call_(call), times_(times) {}
  void load(const double *in, int stride, int cases) override {
    pose_.assign(in, in + 16);
    x_.clear();
    for (int k = 0; k < times_; ++k)
      for (int i = 0; i < cases; ++i) x_.insert(x_.end(), in + i * stride + 16, in + i * stride + 19);
    y_.resize(x_.size());
  }
  void run() override { call_(x_.size() / 3, pose_.data(), x_.data(), y_.data()); }
  void store(double *, int) const override {}

private:
  call call_;
  int times_;
  std::vector<Real> pose_, x_, y_;
};

template <class Real> void add_clouds(library &library, typename cloud_task<Real>::call call) {
  const auto add = [&](const char *name, int times) {
    library.entries.push_back({name, sizeof(Real) == sizeof(float), 0, 0,
                               [=] { return std::make_unique<cloud_task<Real> >(call, times); }, ""});
  };
  add("cloud_in_cache", 1);
  add("cloud_beyond_cache", cloud_thousands);
}

template <class Real> void copy_cloud(std::size_t points, const Real *, const Real *x, Real *y) {
  std::memcpy(y, x, 3 * points * sizeof(Real));
  __asm__ volatile("" : : "r"(y) : "memory"); /* somebody reads it */
}

} // namespace

void describe_chasles_arrays(library &library) {
  library.name = "chasles array";
  library.version = CHS_VERSION;
#define ONE_BY_ONE(real, f, name, inputs, outputs)                                                \
  add_array<real>(library, #name, inputs, outputs, [](std::size_t n, const real *in, real *out) { \
    chs_##name##_array##f(n, in, inputs, out, outputs, nullptr);                                  \
  });
#define METHOD(real, f, name)                                                                                 \
  add_array<real>(                                                                                            \
      library, "motion_" #name, 19, 16,                                                                       \
      [](std::size_t n, const real *in, real *out) {                                                          \
        chs_motion_##name##_array##f(n, in, 19, in + 9, 19, in[18], room<chs_screw##f>(n), out, 16, nullptr); \
      },                                                                                                      \
      8);
#define ARRAYS(real, f)                                                                          \
  ONE_BY_ONE(real, f, so3_exp, 3, 9)                                                             \
  ONE_BY_ONE(real, f, so3_log, 9, 3)                                                             \
  ONE_BY_ONE(real, f, se3_exp, 6, 16)                                                            \
  ONE_BY_ONE(real, f, se3_log, 16, 6)                                                            \
  add_array<real>(library, "se3_compose", 32, 16, [](std::size_t n, const real *in, real *out) { \
    chs_se3_compose_array##f(n, in, 32, in + 16, 32, out, 16);                                   \
  });                                                                                            \
  add_array<real>(library, "se3_apply", 19, 3, [](std::size_t n, const real *in, real *out) {    \
    chs_se3_apply_array##f(n, in, 19, in + 16, 19, out, 3);                                      \
  });                                                                                            \
  add_array<real>(library, "tilt_error", 18, 1, [](std::size_t n, const real *in, real *out) {   \
    chs_tilt_error_array##f(n, in, 18, in + 9, 18, out, room<real>(n), nullptr);                 \
  });                                                                                            \
  add_array<real>(library, "screw_from_pose", 16, 0, [](std::size_t n, const real *in, real *) { \
    chs_screw_from_pose_array##f(n, in, 16, room<chs_screw##f>(n), nullptr);                     \
  });                                                                                            \
  METHOD(real, f, bottema_roth)                                                                  \
  METHOD(real, f, laub_shiflett)                                                                 \
  METHOD(real, f, spoor_veldpaus)
  ARRAYS(double, )
  ARRAYS(float, f)
}

void describe_memcpy(library &library) {
  library.name = "memcpy";
  library.version = "of the C library";
  add_clouds<double>(library, copy_cloud<double>);
  add_clouds<float>(library, copy_cloud<float>);
}

void describe_chasles_scenes(library &library) {
  describe_precision<double>(library);
  describe_precision<float>(library);
  add_clouds<double>(library, [](std::size_t n, const double *T, const double *x, double *y) {
    chs_se3_apply_array(n, T, 0, x, 3, y, 3);
  });
  add_clouds<float>(library, [](std::size_t n, const float *T, const float *x, float *y) {
    chs_se3_apply_arrayf(n, T, 0, x, 3, y, 3);
  });
}
