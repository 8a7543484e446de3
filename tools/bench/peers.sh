#!/usr/bin/env bash
# Installs what the benchmark compares chasles with, and what draws its figure:
#
#   tools/bench/peers.sh [DIRECTORY]     default: build/bench/peers
#
# Debian's packages where apt-get and root are at hand, and a Python environment in DIRECTORY, for the wheels of
# Pinocchio and MuJoCo carry headers and libraries. With another directory tell CMake -DCHASLES_PEERS_DIR=DIRECTORY.
# Whatever cannot be installed is named as missing by the benchmark; this script then ends with status 1.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
directory=${1:-build/bench/peers}
failed=0

packages=(libeigen3-dev libceres-dev liborocos-kdl-dev libmrcal-dev liberfa-dev libcglm-dev llvm valgrind)
if command -v apt-get >/dev/null && [[ $(id -u) == 0 ]]; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get -q update
  for package in "${packages[@]}"; do
    apt-get -q -y install --no-install-recommends "$package" || failed=1
  done
else
  echo "peers.sh: install by hand what is missing of: ${packages[*]}"
fi

python3 -m venv "$directory" || exit 1
while read -r requirement; do
  "$directory/bin/pip" --quiet install "$requirement" || failed=1
done < <(grep -v '^#' tools/bench/requirements.txt)
exit $failed
