#!/usr/bin/env bash
# Draws the pictures of docs/obstacles.md anew: the mast of examples/ways-round.geojson driven round with four
# turning radii, and the copse; and a pylon of examples/riverside.geojson as in the paper and by the cheapest way.
# Usage: draw_detours.sh [BUILD_DIR]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build/release}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

draw() {  # FIELD RADIUS NAME
  "$build/apps/tramline/tramline" plan examples/ways-round.geojson --where "id = '$1'" --strategy sweep --width 3 --radius "$2" \
    --quiet --zoom-obstacles "$scratch/$3"
  mv "$scratch/$3/$1-obstacle-1.png" "docs/images/$3.png"
}

for radius in 3 6 9 12; do
  draw mast "$radius" "detour-radius-$radius"
done
draw copse 6 detour-large-obstacle

draw_pylon() {  # NAME OPTION …
  "$build/apps/tramline/tramline" plan examples/riverside.geojson --strategy sweep --width 3 --radius 6 --quiet \
    --zoom-obstacles "$scratch/$1" "${@:2}"
  mv "$scratch/$1/riverside-obstacle-1.png" "docs/images/$1.png"
}

draw_pylon detour-paper --avoid paper --avoid-threshold 8
draw_pylon detour-cheapest
