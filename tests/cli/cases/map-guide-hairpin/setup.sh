#!/usr/bin/env bash
cat > guide.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "hairpin"}, "geometry": {"type": "LineString", "coordinates": [[7.666732, 48.088021], [7.668009, 48.088021], [7.666732, 48.088023]]}}]}
JSON
