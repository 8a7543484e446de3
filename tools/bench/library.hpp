/* library.hpp - what the benchmark knows of a library: its functions, each over many cases in the library's own types.
 *
 * Cases travel as flat arrays of double in the order of tools/chasles/functions.def; a float is exact in one. A
 * library's source says in a line which of its functions answers to which of ours:
 *
 *   add<double, Matrix3d, Vector3d>(library, "so3_exp", [](const Vector3d &w, Matrix3d &R) { R = ...; });
 *
 * The types after the precision are the output's and the inputs'; codec<Real, Type> takes each to and from its part of
 * the flat array. Conversion is outside of what is timed, the loop over the cases inside.
 */
#ifndef LIBRARY_HPP
#define LIBRARY_HPP

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

/* One function over many cases. */
class task {
public:
  virtual ~task() = default;
  virtual void load(const double *in, int stride, int cases) = 0;
  virtual void run() = 0;
  virtual void store(double *out, int stride) const = 0;
};

struct entry {
  std::string function; /* the name in functions.def or scenes.def */
  bool single;          /* in float */
  int first_output;     /* of the function's outputs those are given that start here, */
  int outputs;          /* this many */
  std::function<std::unique_ptr<task>()> make;
  std::string remark; /* where the library does something else than asked, what */
};

struct library {
  std::string name;
  std::string version;
  std::vector<entry> entries;
};

/* Every plug-in has this function, and shows nothing else. */
extern "C" __attribute__((visibility("default"))) void describe_library(library &library);

template <class Real, class Type> struct codec;

template <class Real, std::size_t N> struct codec<Real, std::array<Real, N> > {
  static constexpr int size = N;
  static void get(const double *flat, std::array<Real, N> &x) {
    for (std::size_t i = 0; i < N; ++i) x[i] = static_cast<Real>(flat[i]);
  }
  static void put(const std::array<Real, N> &x, double *flat) {
    for (std::size_t i = 0; i < N; ++i) flat[i] = static_cast<double>(x[i]);
  }
};

template <class Real> struct codec<Real, Real> {
  static constexpr int size = 1;
  static void get(const double *flat, Real &x) { x = static_cast<Real>(*flat); }
  static void put(const Real &x, double *flat) { *flat = static_cast<double>(x); }
};

/* A pose with its last row, from a rotation and a position read by (row, column) and (row). */
template <class Rotation, class Position> void put_pose(const Rotation &R, const Position &p, double *flat) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) flat[4 * i + j] = static_cast<double>(R(i, j));
    flat[4 * i + 3] = static_cast<double>(p(i));
    flat[12 + i] = 0.0;
  }
  flat[15] = 1.0;
}

template <class Real, class Function, class Out, class... In> class task_of final : public task {
public:
  explicit task_of(Function function) : function_(function) {}

  void load(const double *in, int stride, int cases) override {
    in_.resize(static_cast<std::size_t>(cases));
    out_.resize(static_cast<std::size_t>(cases));
    for (auto &inputs : in_) {
      const double *block = in;
      std::apply([&](auto &...x) { (get(block, x), ...); }, inputs);
      in += stride;
    }
  }

  void run() override {
    const std::size_t cases = in_.size();
    for (std::size_t i = 0; i < cases; ++i) std::apply([&](const auto &...x) { function_(x..., out_[i]); }, in_[i]);
  }

  void store(double *out, int stride) const override {
    for (const auto &result : out_) {
      codec<Real, Out>::put(result, out);
      out += stride;
    }
  }

private:
  template <class Type> static void get(const double *&block, Type &x) {
    codec<Real, Type>::get(block, x);
    block += codec<Real, Type>::size;
  }

  Function function_;
  std::vector<std::tuple<In...> > in_;
  std::vector<Out> out_;
};

template <class Real, class Out, class... In, class Function>
entry &add(library &library, const char *name, Function function, int first_output = 0) {
  library.entries.push_back({name, sizeof(Real) == sizeof(float), first_output, codec<Real, Out>::size,
                             [function] { return std::make_unique<task_of<Real, Function, Out, In...> >(function); },
                             ""});
  return library.entries.back();
}

#endif
