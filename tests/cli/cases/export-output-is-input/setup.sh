#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width 12 --quiet -o plan.gpkg >/dev/null
mv plan.gpkg plan.zip
