cat >field.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "fence"},
 "geometry": {"type": "LineString", "coordinates": [[9.0, 54.0], [9.003, 54.0], [9.003, 54.0018], [9.0, 54.0018]]}}]}
JSON
