#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width 12 --radius 6 --quiet -o plan.gpkg >/dev/null
