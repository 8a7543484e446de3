/* main.cpp - times every function of chasles beside those of other libraries, and measures the errors of all.
 *
 *   bench FLAVOUR VECTORS ROUNDS OUT.json [--only=FUNCTION]... [PLUG-IN...]
 *
 * For each function, precision, set of angles and number of cases the libraries take turns: a round is one turn of
 * each, so that whatever disturbs the machine disturbs all alike. A turn goes through the cases once unmeasured, so
 * that they are where a loop would have them, and then as often as fills a few tens of microseconds. What is reported
 * is the median over the rounds, of a library's time and of its ratio to that of chasles in the same round.
 */
#include <chasles/chasles.h>
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>

#include "accuracy.hpp"
#include "calls.h"
#include "random_inputs.hpp"
#include "scenes.hpp"

void describe_chasles_scenes(library &library);
void describe_chasles_arrays(library &library);
void describe_memcpy(library &library);

namespace {

constexpr int numbers_of_cases[] = {1024, 8192};
constexpr double turn = 20e-6; /* seconds */
constexpr double most = 2.0;   /* seconds for all rounds: slow functions have fewer, but at least */
constexpr int least_rounds = 3;

/* A function of the registry through its loop in calls.c or inlined.c. */
template <class Real> class own_task final : public task {
public:
  explicit own_task(const struct calls &function) : function_(function) {}
  void load(const double *in, int stride, int cases) override {
    cases_ = cases;
    in_.resize(static_cast<std::size_t>(cases) * static_cast<std::size_t>(function_.inputs));
    out_.resize(static_cast<std::size_t>(cases) * static_cast<std::size_t>(function_.outputs) + 1);
    for (int i = 0; i < cases; ++i) {
      for (int k = 0; k < function_.inputs; ++k)
        in_[static_cast<std::size_t>(i * function_.inputs + k)] = static_cast<Real>(in[i * stride + k]);
    }
  }
  void run() override { loop(in_.data(), out_.data()); }
  void store(double *out, int) const override { std::copy(out_.begin(), out_.end() - 1, out); }

private:
  void loop(const double *in, double *out) { function_.loop(in, out, cases_); }
  void loop(const float *in, float *out) { function_.loopf(in, out, cases_); }
  const struct calls &function_;
  int cases_ = 0;
  std::vector<Real> in_;
  std::vector<Real> out_;
};

void describe_calls(const struct calls *calls, int count, library &own) {
  for (int i = 0; i < count; ++i) {
    const struct calls &function = calls[i];
    own.entries.push_back({function.name, false, 0, function.outputs,
                           [&function] { return std::make_unique<own_task<double> >(function); }, ""});
    own.entries.push_back({function.name, true, 0, function.outputs,
                           [&function] { return std::make_unique<own_task<float> >(function); }, ""});
  }
}

library chasles() {
  library own{"chasles", CHS_VERSION, {}};
  describe_calls(calls, calls_count, own);
  describe_chasles_scenes(own);
  return own;
}

library chasles_inlined() {
  library own{"chasles inlined", CHS_VERSION, {}};
  describe_calls(inlined, inlined_count, own);
  return own;
}

bool load_plug_in(const char *name, std::vector<library> &libraries) {
  void *handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  void *symbol = handle == nullptr ? nullptr : dlsym(handle, "describe_library");
  if (symbol == nullptr) {
    std::fprintf(stderr, "bench: %s\n", dlerror());
    return false;
  }
  decltype(&describe_library) function = nullptr;
  std::memcpy(&function, &symbol, sizeof function);
  libraries.emplace_back();
  function(libraries.back());
  return true;
}

/* What is timed: a function of the registry, or a scene. Array forms run beside the single ones, as a library. */
struct subject {
  std::string name;
  std::string kinds;
  int inputs;
  int outputs;
  const struct function *function; /* NULL for a scene */
};

std::vector<subject> all_subjects() {
  std::vector<subject> found;
  for (int i = 0; i < function_count; ++i) {
    if (std::strstr(functions[i].name, "_array") != nullptr) continue;
    found.push_back({functions[i].name, functions[i].kinds, functions[i].inputs, functions[i].outputs, &functions[i]});
  }
#define SCENE(name, kinds, inputs, outputs) found.push_back({#name, kinds, inputs, outputs, nullptr});
#include "scenes.def"
#undef SCENE
  return found;
}

/* Everything about one function in one precision. */
struct contest {
  const subject &what;
  bool single;
  std::vector<const library *> who; /* chasles is the first */
  std::vector<const entry *> with;
  reference vectors;
  bool has_vectors;
};

double quantile(std::vector<double> x, double q) {
  const auto at = static_cast<std::ptrdiff_t>(q * static_cast<double>(x.size() - 1) + 0.5);
  std::nth_element(x.begin(), x.begin() + at, x.end());
  return x[static_cast<std::size_t>(at)];
}

double seconds_of(task &task, int passes) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  for (int i = 0; i < passes; ++i) task.run();
  return std::chrono::duration<double>(clock::now() - start).count() / passes;
}

/* A cycle, if the processor adds integers in one: the time of a dependent addition. */
double nanoseconds_of_a_cycle() {
  constexpr int additions = 4000000;
  double least = 1.0;
  for (int trial = 0; trial < 9; ++trial) {
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t sum = 0;
    for (int i = 0; i < additions; ++i) {
      sum += 3;
      __asm__ volatile("" : "+r"(sum));
    }
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least / additions * 1e9;
}

/* Inputs of the random kinds; where a kind has none, reference vectors drawn at random. */
std::vector<double> inputs_of(const contest &contest, angles set, int cases) {
  const subject &what = contest.what;
  if (has_random_inputs(what.kinds)) return random_inputs(what.kinds, contest.single, set, cases, 1);
  const std::vector<const double *> choice = contest.vectors.inputs(set == angles::ordinary);
  std::vector<double> in;
  std::uint64_t state = 1;
  for (int i = 0; i < cases && !choice.empty(); ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double *drawn = choice[(state >> 33) % choice.size()];
    in.insert(in.end(), drawn, drawn + what.inputs);
  }
  return in;
}

class json {
public:
  explicit json(std::FILE *file) : file_(file) {}
  void begin(const char *flavour, const std::vector<library> &libraries) {
    std::fprintf(file_, "{\n  \"flavour\": \"%s\",\n  \"compiler\": \"%s\",\n  \"libraries\": {", flavour,
#if defined(__clang__)
                 __VERSION__
#else
                 "gcc " __VERSION__
#endif
    );
    for (std::size_t i = 0; i < libraries.size(); ++i)
      std::fprintf(file_, "%s\"%s\": \"%s\"", i == 0 ? "" : ", ", libraries[i].name.c_str(),
                   libraries[i].version.c_str());
    std::fprintf(file_, "},\n  \"cycle_ns\": %.4f,\n  \"errors\": [", nanoseconds_of_a_cycle());
  }
  void between() {
    std::fputs("\n  ],\n  \"times\": [", file_);
    first_ = true;
  }
  void end() { std::fputs("\n  ]\n}\n", file_); }

  void record(const contest &contest, const library &library) {
    std::fprintf(file_, "%s\n    {\"function\": \"%s\", \"precision\": \"%s\", \"library\": \"%s\"", first_ ? "" : ",",
                 contest.what.name.c_str(), contest.single ? "float" : "double", library.name.c_str());
    first_ = false;
  }
  void text(const char *key, const std::string &value) { std::fprintf(file_, ", \"%s\": \"%s\"", key, value.c_str()); }
  /* JSON has no infinity. */
  void number(const char *key, double value) {
    if (std::isinf(value))
      std::fprintf(file_, ", \"%s\": \"inf\"", key);
    else
      std::fprintf(file_, ", \"%s\": %.6g", key, value);
  }
  void close() { std::fputc('}', file_); }

private:
  std::FILE *file_;
  bool first_ = true;
};

void measure_errors(const contest &contest, json &out) {
  for (std::size_t i = 0; i < contest.who.size() && contest.has_vectors; ++i) {
    const errors found = contest.vectors.measure(*contest.with[i]);
    out.record(contest, *contest.who[i]);
    if (!contest.with[i]->remark.empty()) out.text("remark", contest.with[i]->remark);
    for (int k = 0; k < regions; ++k)
      if (found.worst[k] >= 0.0) out.number(region_names[k], found.worst[k]);
    out.close();
  }
}

/* How far the results are from those of chasles, at most, relative to the largest number of a case. */
double largest_difference(const task &own, const task &other, const contest &contest, const entry &entry, int cases) {
  const auto outputs = static_cast<std::size_t>(contest.what.outputs);
  std::vector<double> a(static_cast<std::size_t>(cases) * outputs), b = a;
  own.store(a.data(), contest.what.outputs);
  other.store(b.data() + entry.first_output, contest.what.outputs);
  double largest = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(cases); ++i) {
    double size = 0.0;
    double off = 0.0;
    for (int k = entry.first_output; k < entry.first_output + entry.outputs; ++k) {
      const std::size_t at = i * outputs + static_cast<std::size_t>(k);
      size = std::fmax(size, std::fabs(a[at]));
      off = std::isnan(b[at]) ? static_cast<double>(INFINITY) : std::fmax(off, std::fabs(a[at] - b[at]));
    }
    if (off > 0.0) largest = std::fmax(largest, off / size);
  }
  return largest;
}

void take_turns(const contest &contest, angles set, int cases, int rounds, json &out) {
  const std::vector<double> in = inputs_of(contest, set, cases);
  if (in.empty()) return;
  std::vector<std::unique_ptr<task> > tasks;
  std::vector<int> passes;
  double round_takes = 0.0;
  for (const entry *entry : contest.with) {
    tasks.push_back(entry->make());
    tasks.back()->load(in.data(), contest.what.inputs, cases);
    seconds_of(*tasks.back(), 1);
    const double once = seconds_of(*tasks.back(), 1);
    passes.push_back(std::max(1, static_cast<int>(std::ceil(turn / once))));
    round_takes += once * (1 + passes.back());
  }
  rounds = std::max(std::min(rounds, static_cast<int>(most / round_takes)), std::min(rounds, least_rounds));
  std::vector<std::vector<double> > times(tasks.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      tasks[i]->run();
      times[i].push_back(seconds_of(*tasks[i], passes[i]) / cases * 1e9);
    }
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    std::vector<double> ratios;
    for (std::size_t r = 0; r < times[i].size(); ++r) ratios.push_back(times[i][r] / times[0][r]);
    out.record(contest, *contest.who[i]);
    out.text("angles", angles_name(set));
    out.number("cases", cases);
    out.number("ns", quantile(times[i], 0.5));
    out.number("quartile_1", quantile(times[i], 0.25));
    out.number("quartile_3", quantile(times[i], 0.75));
    out.number("ratio", quantile(ratios, 0.5));
    out.number("difference", largest_difference(*tasks[0], *tasks[i], contest, *contest.with[i], cases));
    out.close();
  }
}

std::vector<contest> all_contests(const std::vector<subject> &subjects, const std::vector<std::string> &only,
                                  const std::vector<library> &libraries, const std::string &vectors) {
  std::vector<contest> contests;
  for (const subject &what : subjects) {
    if (!only.empty() && std::find(only.begin(), only.end(), what.name) == only.end()) continue;
    for (const bool single : {false, true}) {
      contest next{what, single, {}, {}, {}, false};
      for (const library &library : libraries) {
        for (const entry &entry : library.entries) {
          if (entry.function != what.name || entry.single != single) continue;
          next.who.push_back(&library);
          next.with.push_back(&entry);
        }
      }
      if (next.who.empty() || next.who[0] != &libraries[0]) continue; /* ours is not there yet */
      if (what.function != nullptr) next.has_vectors = next.vectors.read(vectors, *what.function, single);
      contests.push_back(std::move(next));
    }
  }
  return contests;
}

/* A line of progress on standard error. */
void report(const contest &contest) {
  std::fprintf(stderr, "%s%s\n", contest.what.name.c_str(), contest.single ? "f" : "");
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 5) {
    std::fputs("usage: bench FLAVOUR VECTORS ROUNDS OUT.json [--only=FUNCTION]... [PLUG-IN...]\n", stderr);
    return 2;
  }
  const int rounds = std::atoi(argv[3]);
  std::vector<library> libraries = {chasles(), chasles_inlined(), {}, {}};
  describe_chasles_arrays(libraries[2]);
  describe_memcpy(libraries[3]);
  std::vector<std::string> only;
  for (int i = 5; i < argc; ++i) {
    if (std::strncmp(argv[i], "--only=", 7) == 0)
      only.push_back(argv[i] + 7);
    else if (!load_plug_in(argv[i], libraries))
      return 2;
  }
  std::FILE *file = std::fopen(argv[4], "w");
  if (file == nullptr || rounds < 1) {
    std::fprintf(stderr, "bench: cannot write %s, or no rounds\n", argv[4]);
    return 2;
  }

  const std::vector<subject> subjects = all_subjects();
  const std::vector<contest> contests = all_contests(subjects, only, libraries, argv[2]);
  json out(file);
  out.begin(argv[1], libraries);
  for (const contest &contest : contests) measure_errors(contest, out);
  out.between();
  for (const contest &contest : contests) {
    report(contest);
    const bool beyond = has_random_inputs(contest.what.kinds) && angles_are_given(contest.what.kinds);
    if (contest.what.function == nullptr) { /* a scene, slow and with no angle of its own */
      take_turns(contest, angles::ordinary, numbers_of_cases[0], rounds, out);
      continue;
    }
    for (const angles set : all_angles) {
      if (set == angles::beyond && !beyond) continue;
      for (const int cases : numbers_of_cases) take_turns(contest, set, cases, rounds, out);
    }
  }
  out.end();
  return std::fclose(file) == 0 ? 0 : 2;
}
