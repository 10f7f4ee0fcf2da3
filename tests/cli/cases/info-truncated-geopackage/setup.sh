#!/usr/bin/env bash
ogr2ogr -q -f GPKG whole.gpkg "$COMMON/one-field.geojson"
head -c "$(($(stat -c %s whole.gpkg) / 3))" whole.gpkg >field.gpkg
rm whole.gpkg
