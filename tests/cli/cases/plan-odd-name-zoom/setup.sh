#!/usr/bin/env bash
cat > fields.geojson <<'END'
{"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"id": ".hidden"}, "geometry": {"type": "Polygon", "coordinates": [
  [[9.0, 54.0], [9.002, 54.0], [9.002, 54.001], [9.0, 54.001], [9.0, 54.0]],
  [[9.001, 54.0005], [9.001, 54.00053], [9.00105, 54.00053], [9.00105, 54.0005], [9.001, 54.0005]]]}},
 {"type": "Feature", "properties": {"id": "/-/"}, "geometry": {"type": "Polygon", "coordinates": [
  [[9.01, 54.0], [9.012, 54.0], [9.012, 54.001], [9.01, 54.001], [9.01, 54.0]],
  [[9.011, 54.0005], [9.011, 54.00053], [9.01105, 54.00053], [9.01105, 54.0005], [9.011, 54.0005]]]}}
]}
END
