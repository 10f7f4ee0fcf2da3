#!/usr/bin/env bash
cat > guide.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "short"}, "geometry": {"type": "LineString", "coordinates": [[7.66737, 48.088021], [7.6673714, 48.0880205]]}}]}
JSON
