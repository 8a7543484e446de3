# Help, version, and arguments that make no sense.
PROGRAM=$1
version=$2
. "$(dirname "$0")/expect.sh"

# All that the program has, as its help lists them.
run 0 --help
commands=$(sed -n '/^subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' out | grep -vx help)
[ "$(echo "$commands" | wc -l)" -eq 9 ] || fail "nine subcommands expected"

run 0 --version
[ "$(cat out)" = "chasles $version" ] || fail "the version should be $version"

for help in --help -h help; do
  run 0 "$help"
  err_empty
  for command in $commands; do out_has "  $command"; done
done

for command in $commands; do
  run 0 help "$command"
  cp out help
  err_empty
  for part in "usage: chasles $command" 'options' 'exit status:' 'examples:' '  --help'; do out_has "$part"; done
  run 0 "$command" --help
  cmp -s out help || fail "--help and help differ"
  [ "$(awk '{ if (length($0) > 120) n++ } END { print n + 0 }' out)" -eq 0 ] || fail "a line is too long"
  run 2 "$command" --bogus
  err_is "chasles: unknown or ambiguous option '--bogus'; see 'chasles help $command'"
  run 2 "$command" -z
  err_is "chasles: unknown option '-z'; see 'chasles help $command'"
  run 2 "$command" --help=yes
  err_is "chasles: option '--help=yes' takes no value; see 'chasles help $command'"
done

run 2
err_is "chasles: no subcommand given; see 'chasles --help'"
run 2 comprae
err_is "chasles: 'comprae' is not a subcommand; see 'chasles --help'"
run 2 help comprae
err_is "chasles: 'comprae' is not a subcommand; see 'chasles --help'"
run 2 help solve study
err_is "chasles: help takes no argument 'study'; see 'chasles --help'"
run 2 --version solve
err_is "chasles: --version takes no argument 'solve'; see 'chasles --help'"
run 2 --bogus
err_is "chasles: unknown option '--bogus'; see 'chasles --help'"
run 2 compare
err_is "chasles: compare expects a directory or a file of vectors; see 'chasles help compare'"
run 2 compare --json
err_is "chasles: option '--json' expects a value; see 'chasles help compare'"
run 2 compare --worst many .
err_is "chasles: --worst expects a number from 0 to 10000, not 'many'"
run 2 solve
err_is "chasles: solve expects one file of markers; see 'chasles help solve'"
run 2 hash extra
err_is "chasles: hash takes no argument 'extra'; see 'chasles help hash'"

# An output that cannot be written is an error, also standard output.
if [ -c /dev/full ]; then
  ran='--help >/dev/full'
  "$PROGRAM" --help >/dev/full 2>err
  status=$?
  [ "$status" -eq 2 ] || fail "a full disk should be an error"
fi

finish
