cat >field.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "beyond"},
 "geometry": {"type": "Polygon", "coordinates": [[[9.0, 95.0], [9.003, 95.0], [9.003, 95.0018], [9.0, 95.0018], [9.0, 95.0]]]}}]}
JSON
