# What the scripts here share. Sourced after PROGRAM is set; ends with `finish`.
failures=0
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2

fail() {
  failures=$((failures + 1))
  echo "FAIL: $*"
  echo "  ran: chasles $ran"
  echo "  status $status"
  sed 's/^/  out: /' out
  sed 's/^/  err: /' err
}

# Runs the program; its exit status must be $1.
run() {
  wanted=$1
  shift
  ran="$*"
  "$PROGRAM" "$@" >out 2>err
  status=$?
  [ "$status" -eq "$wanted" ] || fail "exit status $wanted expected"
}

# Standard output, standard error or a file holds this text on some line.
out_has() { grep -qF -e "$1" out || fail "standard output lacks: $1"; }
out_lacks() { if grep -qF -e "$1" out; then fail "standard output has: $1"; fi; }
file_has() { grep -qF -e "$2" "$1" || fail "$1 lacks: $2"; }

# Standard error is this line and no other; nothing; or starts with this line.
err_is() { [ "$(cat err)" = "$1" ] || fail "standard error should be: $1"; }
err_empty() { [ ! -s err ] || fail "standard error should be empty"; }
err_starts() { [ "$(head -n 1 err)" = "$1" ] || fail "standard error should start with: $1"; }

finish() {
  [ "$failures" -eq 0 ] || exit 1
}
