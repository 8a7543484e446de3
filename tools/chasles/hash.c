/* hash.c - chasles hash: one number for the bits of all results. */
#include <chasles/chasles.h>
#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands.h"
#include "inputs.h"
#include "selection.h"
#include "text.h"

const char hash_help[] =
    "usage: chasles hash [options]\n"
    "\n"
    "Calls every function of the library, in double and in float, on a large set of random inputs and prints one\n"
    "64-bit hash of the statuses and of the bits of all results. The inputs are the same on every machine, and the\n"
    "library promises the same bits on every machine, so the line must be the same for every compiler, optimisation\n"
    "level and target. They reach from the least to the greatest numbers, angles near and beyond pi, exact half-\n"
    "turns, drifted and broken matrices, thin and degenerate triangles, NaN and infinity.\n"
    "\n"
    "options:\n"
    "  --seed N           start of the random inputs, 0 to 2^64 - 1 (default: 1)\n"
    "  --cases N          inputs for each function and precision (default: 20000)\n"
    "  --only FUNCTION    call this function only; may be repeated, or hold several parted by commas\n"
    "                     (default: all)\n"
    "  --each             first a line for each function and precision, which tells where two machines differ: its\n"
    "                     hash, and how many cases had status 0, a positive and a negative one\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  the hash was printed\n"
    "  2  unusable arguments, or the output cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles hash\n"
    "  chasles hash --each --only so3_exp,so3_log --cases 100000\n";

enum { MOST_CASES = 1000000000 };

struct options {
  struct selection only;
  uint64_t seed;
  long cases;
  bool each;
};

/* FNV-1a over the eight bytes of a word, lowest first whatever the machine's order. */
static uint64_t hash_word(uint64_t hash, uint64_t word) {
  for (int i = 0; i < 8; ++i) hash = (hash ^ ((word >> (8 * i)) & 0xffu)) * 0x100000001b3u;
  return hash;
}

static const uint64_t hash_start = 0xcbf29ce484222325u;

/* NaNs differ in sign and payload from one machine to the next: they are all hashed as one. */
static uint64_t hash_number(uint64_t hash, double x, enum precision precision) {
  return hash_word(hash, isnan(x) ? UINT64_MAX : precision_bits(x, precision));
}

static uint64_t hash_answer(uint64_t hash, const struct function *function, enum precision precision,
                            const struct answer *answer) {
  hash = hash_word(hash, (uint64_t)(int64_t)answer->status);
  for (int i = 0; i < function->outputs && answer->status >= 0; ++i)
    hash = hash_number(hash, answer->out[i], precision);
  return hash;
}

static uint64_t hash_function(const struct function *function, enum precision precision,
                              const struct options *options) {
  struct source source = source_for(function, precision, options->seed);
  uint64_t hash = hash_start;
  long counts[3] = {0, 0, 0}; /* status 0, positive, negative */
  for (long i = 0; i < options->cases; ++i) {
    double in[MAX_INPUTS];
    struct answer answer;
    make_inputs(&source, function, in);
    evaluate(function, precision, in, &answer);
    hash = hash_answer(hash, function, precision, &answer);
    ++counts[answer.status == 0 ? 0 : answer.status > 0 ? 1 : 2];
  }
  if (options->each) {
    printf("%-28s %-6s %016" PRIx64 " %8ld %8ld %8ld\n", function->name, precision_name(precision), hash, counts[0],
           counts[1], counts[2]);
  }
  return hash;
}

static int hash_library(const struct options *options) {
  uint64_t hash = hash_start;
  for (int i = 0; i < function_count; ++i) {
    if (kinds_are_right(&functions[i])) continue;
    complain("functions.def: the kinds of %s do not make its %d inputs", functions[i].name, functions[i].inputs);
    return UNUSABLE;
  }
  if (options->each) {
    printf("%-28s %-6s %-16s %8s %8s %8s\n", "function", "format", "hash", "ok", "special", "error");
  }
  for (int i = 0; i < function_count; ++i) {
    for (int k = 0; k < PRECISIONS && selection_has(&options->only, &functions[i]); ++k) {
      hash = hash_word(hash, hash_function(&functions[i], (enum precision)k, options));
    }
  }
  printf("chasles " CHS_VERSION " seed %" PRIu64 " cases %ld hash %016" PRIx64 "\n", options->seed, options->cases,
         hash);
  return ALL_WELL;
}

static bool parse_seed(const char *text, uint64_t *seed) {
  if (!isdigit((unsigned char)*text)) return false;
  char *end = NULL;
  errno = 0;
  const uintmax_t value = strtoumax(text, &end, 10);
  *seed = (uint64_t)value;
  return *end == '\0' && errno == 0 && value <= UINT64_MAX;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"seed", required_argument, NULL, 's'}, {"cases", required_argument, NULL, 'c'},
                                        {"only", required_argument, NULL, 'o'}, {"each", no_argument, NULL, 'e'},
                                        {"help", no_argument, NULL, 'h'},       {NULL, 0, NULL, 0}};
  int option;
  while ((option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 's':
      if (parse_seed(optarg, &options->seed)) break;
      complain("--seed expects a number from 0 to %" PRIu64 ", not '%s'", UINT64_MAX, optarg);
      return UNUSABLE;
    case 'c':
      if (parse_integer(optarg, 1, MOST_CASES, &options->cases)) break;
      complain("--cases expects a number from 1 to %d, not '%s'", (int)MOST_CASES, optarg);
      return UNUSABLE;
    case 'o':
      if (!selection_add(&options->only, optarg)) return UNUSABLE;
      break;
    case 'e': options->each = true; break;
    case 'h': fputs(hash_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (optind == argc) return -1;
  complain("hash takes no argument '%s'; see 'chasles help hash'", argv[optind]);
  return UNUSABLE;
}

int hash_command(int argc, char **argv) {
  struct options options = {{NULL}, 1, 20000, false};
  int status = read_options(argc, argv, &options);
  if (status == -1) status = hash_library(&options);
  selection_free(&options.only);
  return status;
}
