/* random_inputs.hpp - inputs as an application has them, by the kinds of tools/chasles/functions.def. (Those of
 * tools/chasles/inputs.c are there to break things.)
 */
#ifndef RANDOM_INPUTS_HPP
#define RANDOM_INPUTS_HPP

#include <cstdint>
#include <string>
#include <vector>

/* What angles are drawn from. */
enum class angles {
  ordinary, /* (0, pi), even */
  mixed,    /* half ordinary, a quarter tiny, a quarter near pi, in no order */
  beyond    /* (pi, 20) */
};
constexpr angles all_angles[] = {angles::ordinary, angles::mixed, angles::beyond};
const char *angles_name(angles set);

/* False when a letter has no random inputs here: the caller takes reference vectors then. */
bool has_random_inputs(const std::string &kinds);

/* Whether an angle beyond pi means anything to these kinds. */
bool angles_are_given(const std::string &kinds);

/* `cases` times the inputs of that kind, each rounded to the precision. */
std::vector<double> random_inputs(const std::string &kinds, bool single, angles set, int cases, std::uint64_t seed);

#endif
