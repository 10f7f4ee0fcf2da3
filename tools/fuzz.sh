#!/usr/bin/env bash
# Runs fuzz targets, two at a time. What they find out stays in BUILD/corpus, what breaks them in BUILD/findings.
# Usage: fuzz.sh BUILD SECONDS TARGET...
set -euo pipefail

build=$(realpath "$1")
seconds=$2
shift 2
seeds=$(realpath "$(dirname "$0")/../fuzz/seeds")

run_one() {
  local target=$1
  mkdir -p "$build/corpus/$target" "$build/findings/$target"
  if "$build/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 \
    -print_final_stats=1 -artifact_prefix="$build/findings/$target/" \
    "$build/corpus/$target" "$seeds/$target" >"$build/$target.log" 2>&1; then
    echo "$target: $(grep -c . "$build/$target.log") lines in $build/$target.log," \
      "$(sed -n 's/^stat::number_of_executed_units: //p' "$build/$target.log") runs, nothing found"
  else
    tail -n 40 "$build/$target.log"
    echo "$target: broken by what lies in $build/findings/$target" >&2
    return 1
  fi
}
export -f run_one
export build seconds seeds

# shellcheck disable=SC2016 # the inner shell expands it
printf '%s\0' "$@" | xargs -0 -n 1 -P 2 bash -c 'run_one "$1"' _
