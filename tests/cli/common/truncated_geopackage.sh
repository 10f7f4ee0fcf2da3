#!/usr/bin/env bash
# Makes field.gpkg, the first third of a GeoPackage, in the current folder.
set -euo pipefail
ogr2ogr -q -f GPKG whole.gpkg "$COMMON/one-field.geojson"
head -c "$(($(stat -c %s whole.gpkg) / 3))" whole.gpkg >field.gpkg
rm whole.gpkg
