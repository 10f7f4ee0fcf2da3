#!/usr/bin/env bash
cat > guide.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "bend"}, "geometry": {"type": "LineString", "coordinates": [[7.666413, 48.087639], [7.66737, 48.088593], [7.668328, 48.08783]]}}]}
JSON
