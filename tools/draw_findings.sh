#!/usr/bin/env bash
# Draws the pictures of docs/findings.md anew: examples/roadside.geojson under the three scenarios of Versleijen.
# Usage: draw_findings.sh [BUILD_DIR]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${1:-build/release}

for factor in overlap uncovered turns; do
  "$build/apps/tramline/tramline" plan examples/roadside.geojson --strategy sweep --end-rule centre --avoid paper \
    --width 3 --radius 6 --minimise "$factor" --quiet --picture "docs/images/findings-least-$factor.png"
done
