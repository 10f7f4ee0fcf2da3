#!/usr/bin/env bash
ogr2ogr -q -f GPKG field.gpkg "$COMMON/one-field.geojson"
