#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/riverside.geojson" --width 6 --radius 6 --quiet -o plan.gpkg >/dev/null
