/* accuracy.hpp - the errors of any library's function by the committed reference vectors. */
#ifndef ACCURACY_HPP
#define ACCURACY_HPP

#include <string>
#include <vector>

#include "library.hpp"
#include "registry.hpp"

/* The bands of the vectors, gathered. */
enum region { tiny, small, ordinary, near_pi, beyond_pi, regions };
constexpr const char *region_names[regions] = {"tiny", "small", "ordinary", "near_pi", "beyond_pi"};

struct errors {
  double worst[regions]; /* in eps; -1 where there are no vectors, infinite where something is not a number */
};

/* The cases of one function and precision that any library can be held to: those with an answer, for points that are
 * rigid and matrices that are rotations to within rounding. (What a drifted matrix means is each library's own.) */
class reference {
public:
  /* False when there is no such file, or it cannot be read. */
  bool read(const std::string &directory, const struct function &function, bool single);
  errors measure(const entry &entry) const;
  /* The inputs of all cases up to pi, or of the ordinary ones alone. */
  std::vector<const double *> inputs(bool only_ordinary) const;

private:
  struct one {
    vector_case record;
    region where;
  };
  const struct function *function_ = nullptr;
  precision precision_ = DOUBLE_PRECISION;
  std::vector<group> groups_;
  std::vector<one> cases_;
};

#endif
