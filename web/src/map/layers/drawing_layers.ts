// What is being drawn, and the edges that may be picked.
import type { LayerSpecification } from 'maplibre-gl';
import type { Colours } from '../palette';

export const drawingLayers = (c: Colours): LayerSpecification[] => [
  {
    id: 'land', type: 'fill', source: 'land', filter: ['==', ['geometry-type'], 'Polygon'],
    paint: { 'fill-color': ['match', ['get', 'kind'], 'skip', c.NoRoom, 'done', c.Covered, c.Reference], 'fill-opacity': ['match', ['get', 'kind'], 'subfield', 0.06, 0.3] },
  },
  {
    id: 'land-edge', type: 'line', source: 'land', layout: { 'line-join': 'round' },
    paint: { 'line-color': ['match', ['get', 'kind'], 'skip', c.NoRoom, c.Reference], 'line-width': 2.5, 'line-dasharray': [2, 1.5] },
  },
  {
    id: 'edges', type: 'line', source: 'edges', filter: ['==', ['geometry-type'], 'LineString'], layout: { 'line-cap': 'round', 'line-join': 'round' },
    paint: {
      'line-color': c.Reference, 'line-width': ['case', ['get', 'chosen'], 5, 3], 'line-opacity': ['case', ['get', 'chosen'], 1, 0.45],
    },
  },
  {
    id: 'edges-arrow', type: 'symbol', source: 'edges', filter: ['==', ['get', 'chosen'], true],
    layout: { 'symbol-placement': 'line', 'symbol-spacing': 120, 'icon-image': 'arrow:guide', 'icon-allow-overlap': true },
  },
  {
    id: 'edges-gate', type: 'circle', source: 'edges', filter: ['==', ['geometry-type'], 'Point'],
    paint: {
      'circle-radius': 8, 'circle-color': c.Background, 'circle-stroke-width': 3,
      'circle-stroke-color': ['case', ['==', ['get', 'gate'], 'start'], c.RouteStart, c.RouteEnd],
    },
  },
  {
    id: 'drawing-fill', type: 'fill', source: 'drawing', filter: ['==', ['geometry-type'], 'Polygon'],
    paint: { 'fill-color': c.Reference, 'fill-opacity': 0.18 },
  },
  {
    id: 'drawing-line', type: 'line', source: 'drawing', layout: { 'line-cap': 'round', 'line-join': 'round' },
    paint: { 'line-color': c.Reference, 'line-width': 2.5 },
  },
  {
    id: 'drawing-point', type: 'circle', source: 'drawing', filter: ['==', ['geometry-type'], 'Point'],
    paint: {
      'circle-radius': ['case', ['get', 'between'], 4, 7], 'circle-color': ['case', ['get', 'chosen'], c.Reference, c.Background],
      'circle-stroke-color': c.Reference, 'circle-stroke-width': ['case', ['get', 'between'], 1.5, 3],
    },
  },
];
