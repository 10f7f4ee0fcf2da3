#!/usr/bin/env bash
# Makes coverage.gpkg, what the drive on the riverside field covered, in the current folder.
set -euo pipefail
bash "$COMMON/kept.sh" coverage.gpkg \
  "$TRAMLINE" evaluate "$EXAMPLES/riverside-drive.csv" --field "$EXAMPLES/riverside.geojson" --quiet -o coverage.gpkg
