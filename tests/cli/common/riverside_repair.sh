#!/usr/bin/env bash
# Makes coverage.gpkg and repair.gpkg, passes over what the drive has missed, in the current folder.
set -euo pipefail
bash "$COMMON/riverside_coverage.sh"
"$TRAMLINE" repair coverage.gpkg --width 12 --min-area 20 --quiet -o repair.gpkg
