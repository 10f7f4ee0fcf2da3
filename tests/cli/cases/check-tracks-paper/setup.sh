#!/usr/bin/env bash
"$TRAMLINE" map "$EXAMPLES/terrace.kml" --width 6 --radius 6 --headlands 1 --curved always --tracks paper --quiet -o plan.gpkg >/dev/null
