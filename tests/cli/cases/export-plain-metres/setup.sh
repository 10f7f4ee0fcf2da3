#!/usr/bin/env bash
"$TRAMLINE" plan "$EXAMPLES/plain-metres.gpkg" --width 12 --radius 6 --quiet -o plan.gpkg >/dev/null
