// The field and its obstacles. At a review its land has the colour of what is missed.
import type { LayerSpecification } from 'maplibre-gl';
import type { Colours } from '../palette';

const kind = (name: string) => ['==', ['get', 'kind'], name] as never;

export function fieldLayers(c: Colours): { below: LayerSpecification[]; above: LayerSpecification[] } {
  return {
    below: [
      { id: 'field-ground', type: 'fill', source: 'field', filter: kind('field'), paint: { 'fill-color': c.Field } },
      {
        id: 'field-missed', type: 'fill', source: 'field', filter: kind('field'), layout: { visibility: 'none' },
        paint: { 'fill-color': c.Uncovered, 'fill-opacity': 0.55 },
      },
    ],
    above: [
      { id: 'passable', type: 'fill', source: 'field', filter: kind('passable'), paint: { 'fill-pattern': 'hatch:passable' } },
      { id: 'obstacle', type: 'fill', source: 'field', filter: kind('obstacle'), paint: { 'fill-pattern': 'hatch:obstacle' } },
      {
        id: 'obstacle-edge', type: 'line', source: 'field', filter: ['!=', ['get', 'kind'], 'field'],
        paint: { 'line-color': c.Obstacle, 'line-width': 1.2 },
      },
      {
        id: 'field-edge', type: 'line', source: 'field', filter: kind('field'),
        layout: { 'line-join': 'round' }, paint: { 'line-color': c.FieldEdge, 'line-width': 2 },
      },
      {
        id: 'obstacle-number', type: 'symbol', source: 'field', filter: ['all', ['!=', ['get', 'kind'], 'field'], ['has', 'number']],
        layout: { 'icon-image': ['concat', 'obstacle:', ['to-string', ['get', 'number']]], 'icon-padding': 4, visibility: 'none' },
      },
    ],
  };
}
