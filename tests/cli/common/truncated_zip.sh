#!/usr/bin/env bash
# Makes field.zip, the first half of a zipped Shapefile, in the current folder.
set -euo pipefail
ogr2ogr -q -f "ESRI Shapefile" field.shp "$COMMON/one-field.geojson"
zip -q whole.zip field.shp field.shx field.dbf field.prj
head -c "$(($(stat -c %s whole.zip) / 2))" whole.zip >field.zip
rm whole.zip field.shp field.shx field.dbf field.prj
