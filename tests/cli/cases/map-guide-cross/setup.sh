#!/usr/bin/env bash
cat > guide.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "cross"}, "geometry": {"type": "LineString", "coordinates": [[7.666732, 48.088021], [7.668009, 48.088021], [7.66737, 48.088784], [7.66737, 48.087257]]}}]}
JSON
