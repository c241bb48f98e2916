#!/usr/bin/env bash
# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs benchmarks and writes what they print to NAME.txt beside this script: renew.sh NAME...
# serial_share is what scale prints with --serial, and serial_share_in_space with --serial --space.
# The first lines of a file give the command, the day and the machine.

set -euo pipefail

results=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
dev=$results/../../dev

benchmark_of() {
  case $1 in
  serial_share | serial_share_in_space) echo scale ;;
  *) echo "$1" ;;
  esac
}

options_of() {
  case $1 in
  serial_share) echo --serial ;;
  serial_share_in_space) echo --serial --space ;;
  cells | simulation_helpers) echo --benchmark_min_time=0.1 --benchmark_repetitions=7 ;;
  esac
}

[ $# -gt 0 ] || {
  echo "renew.sh NAME...: the benchmarks whose results are renewed; './dev bench' lists them" >&2
  exit 2
}
new=$(mktemp)
trap 'rm -f "$new"' EXIT
for name in "$@"; do
  benchmark=$(benchmark_of "$name")
  read -r -a options <<<"$(options_of "$name")"
  command="./dev bench $benchmark${options[*]:+ ${options[*]}}"
  {
    echo "# $command"
    echo "# Measured on $(date -u +%F); $(nproc) cores, $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)," \
      "$("${CXX:-g++}" --version | head -n 1)"
    echo
    "$dev" bench "$benchmark" "${options[@]}"
  } >"$new"
  cat "$new" >"$results/$name.txt" # not before: a run that fails leaves the last result
  echo "$results/$name.txt"
done
