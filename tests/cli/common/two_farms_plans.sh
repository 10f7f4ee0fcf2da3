#!/usr/bin/env bash
# Makes plans.gpkg, the plans of all fields of the two farms in one file, in the current folder.
set -euo pipefail
bash "$COMMON/kept.sh" plans.gpkg \
  "$TRAMLINE" plan "$EXAMPLES/two-farms.gpkg" --layer parcels --all --width 6 --quiet -o plans.gpkg --one-file
