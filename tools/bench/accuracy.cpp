/* accuracy.cpp - see accuracy.hpp. */
#include "accuracy.hpp"

#include <chasles/chasles.h>
#include <cmath>
#include <fstream>

namespace {

bool is_one_of(const std::string &name, std::initializer_list<const char *> names) {
  for (const char *candidate : names)
    if (name == candidate) return true;
  return false;
}

region region_of(const vector_case &record) {
  const std::string band = record.band;
  if (record.statuses[0] == CHS_HALF_TURN) return near_pi; /* examples among them */
  if (band == "tiny") return tiny;
  if (band == "small") return small;
  if (is_one_of(band, {"near_pi", "at_pi"})) return near_pi;
  if (is_one_of(band, {"beyond_pi", "far"})) return beyond_pi;
  return ordinary;
}

/* The rotation in the upper left corner, rows `stride` apart. */
bool is_rotation(const double *flat, int stride, precision format) {
  double R[9];
  double deviation = 0.0;
  for (int i = 0; i < 9; ++i) R[i] = flat[i / 3 * stride + i % 3];
  return chs_so3_deviation(R, &deviation) == CHS_OK && deviation <= 8.0 * precision_eps(format);
}

bool holds_rotations(const char *kinds, const double *in, precision format) {
  for (; *kinds != '\0'; ++kinds) {
    switch (*kinds) {
    case 'R':
      if (!is_rotation(in, 3, format)) return false;
      in += 9;
      break;
    case 'Q':
      if (!is_rotation(in, 3, format) || !is_rotation(in + 9, 3, format)) return false;
      in += 18;
      break;
    case 'T':
      if (!is_rotation(in, 4, format)) return false;
      in += 16;
      break;
    case 'x':
    case 'w': in += 3; break;
    case 'M': in += 9; break;
    case 'V': in += 6; break;
    case 'S': in += 8; break;
    case 'P': in += 18; break;
    case 't':
    case 'a': in += 1; break;
    default: return true; /* a kind that is not known here: nothing is left out */
    }
  }
  return true;
}

/* At a half-turn e and -e are the same axis; which of the two is returned is each library's choice. out becomes that
 * with the reference's sign: w changes sign, and with it v by w x p = w x v - that is, v by w x (v at the other w). */
void choose_sign(const std::string &function, const vector_case &record, double *out) {
  const bool pose = function == "se3_log";
  if (!pose && function != "so3_log") return;
  const double *w = record.high;
  if (out[0] * w[0] + out[1] * w[1] + out[2] * w[2] >= 0.0) return;
  if (pose) {
    const double p[3] = {record.in[3], record.in[7], record.in[11]};
    const double moved[3] = {out[1] * p[2] - out[2] * p[1], out[2] * p[0] - out[0] * p[2],
                             out[0] * p[1] - out[1] * p[0]};
    for (int i = 0; i < 3; ++i) out[3 + i] += moved[i];
  }
  for (int i = 0; i < 3; ++i) out[i] = -out[i];
}

/* Whether the library gives all outputs of the group, or else none of it. */
bool gives(const entry &entry, const group &group) {
  for (int i = 0; i < group.count; ++i) {
    if (group.index[i] < entry.first_output || group.index[i] >= entry.first_output + entry.outputs) return false;
  }
  return true;
}

} // namespace

bool reference::read(const std::string &directory, const struct function &function, bool single) {
  const std::string name = directory + "/" + function.name + (single ? ".f32.txt" : ".f64.txt");
  vectors file;
  if (!std::ifstream(name) || !vectors_open(&file, name.c_str())) return false;
  function_ = &function;
  precision_ = file.precision;
  groups_.assign(file.groups, file.groups + file.group_count);
  one next;
  enum text_result result;
  while ((result = vectors_next(&file, &next.record)) == TEXT_LINE) {
    const std::string band = next.record.band;
    if (!next.record.has_values || band == "degenerate" || band == "noisy") continue;
    if (!holds_rotations(function.kinds, next.record.in, precision_)) continue;
    next.where = region_of(next.record);
    cases_.push_back(next);
  }
  vectors_close(&file);
  return result == TEXT_END && !cases_.empty();
}

errors reference::measure(const entry &entry) const {
  errors found;
  for (double &worst : found.worst) worst = -1.0;
  const std::unique_ptr<task> task = entry.make();
  for (const one &each : cases_) {
    double out[MAX_OUTPUTS] = {0.0};
    task->load(each.record.in, function_->inputs, 1);
    task->run();
    task->store(out + entry.first_output, function_->outputs);
    if (each.record.statuses[0] == CHS_HALF_TURN) choose_sign(entry.function, each.record, out);
    double &worst = found.worst[each.where];
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (!gives(entry, groups_[i])) continue;
      const double error = group_error(&groups_[i], precision_, &each.record, each.record.scale[i], out);
      worst = std::isnan(error) ? static_cast<double>(INFINITY) : std::fmax(worst, error);
    }
  }
  return found;
}

std::vector<const double *> reference::inputs(bool only_ordinary) const {
  std::vector<const double *> found;
  for (const one &each : cases_) {
    if (each.where == ordinary || (!only_ordinary && each.where != beyond_pi)) found.push_back(each.record.in);
  }
  return found;
}
