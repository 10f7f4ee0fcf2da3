#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/two-farms.gpkg" --layer parcels --where "fid = 1" --width 12 --quiet -o plan.gpkg >/dev/null
