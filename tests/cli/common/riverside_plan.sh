#!/usr/bin/env bash
# Makes plan.gpkg, a plan of the riverside field, in the current folder. Usage: riverside_plan.sh WIDTH
set -euo pipefail
"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width "$1" --radius 6 --quiet -o plan.gpkg
