#!/usr/bin/env bash
# Makes plan.gpkg, a plan of the tracks of the riverside field, in the current folder. Usage: riverside_plan.sh WIDTH
set -euo pipefail
bash "$COMMON/kept.sh" plan.gpkg \
  "$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width "$1" --radius 6 --prices 0.02,0.10,1,5,5 --quiet -o plan.gpkg
