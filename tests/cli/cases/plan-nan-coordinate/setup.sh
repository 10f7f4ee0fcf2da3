cat >field.geojson <<'JSON'
{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "bent"},
 "geometry": {"type": "Polygon", "coordinates": [[[9.0, 54.0], [9.003, 54.0], [NaN, 54.0018], [9.0, 54.0018], [9.0, 54.0]]]}}]}
JSON
