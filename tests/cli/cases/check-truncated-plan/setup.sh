#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width 6 --radius 6 --quiet -o whole.gpkg >/dev/null
head -c "$(($(stat -c %s whole.gpkg) / 3))" whole.gpkg >plan.gpkg
rm whole.gpkg
