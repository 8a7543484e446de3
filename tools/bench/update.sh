#!/usr/bin/env bash
# Makes the committed results anew: results.md, the figure and instructions.txt. Some minutes, on a machine with little
# else to do.
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[[ -d build/bench/peers || -n ${CHASLES_PEERS_DIR-} ]] || tools/bench/peers.sh
cmake --preset bench ${CHASLES_PEERS_DIR+-DCHASLES_PEERS_DIR="$CHASLES_PEERS_DIR"}
cmake --build --preset bench
cp build/bench/tools/bench/{results.md,speed_error.svg,speed_error.png} tools/bench/
tools/bench/instructions.py --write
