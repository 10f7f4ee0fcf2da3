// Every layer of a plan, as the library's pictures draw it.
import type { ExpressionSpecification, LayerSpecification } from 'maplibre-gl';
import type { Colours } from '../palette';

/** One of eight tints, in turn. */
const tint = (c: Colours): ExpressionSpecification =>
  ['at', ['%', ['-', ['to-number', ['get', 'number'], 1], 1], c.Tints.length], ['literal', [...c.Tints]]] as never;
const thin: ExpressionSpecification = ['interpolate', ['linear'], ['zoom'], 14, 0.6, 17, 1.3, 20, 2.4];

/** Legs with the work on lie on tracks and passes, which are drawn already. */
const OFF: ExpressionSpecification = ['in', ['get', 'kind'], ['literal', ['turn', 'transit', 'back_out']]];
const inGear = (gear: string): ExpressionSpecification => ['all', OFF, ['==', ['get', 'gear'], gear]];

/** By kind, in reverse dashed, and where the machine has no room in red. */
function routeLayers(c: Colours): LayerSpecification[] {
  const colour: ExpressionSpecification = [
    'case', ['>', ['to-number', ['get', 'missing_m'], 0], 0], c.NoRoom,
    ['match', ['get', 'kind'], 'turn', c.Turn, 'transit', c.Transit, c.BackOut],
  ];
  const width: ExpressionSpecification = ['interpolate', ['linear'], ['zoom'], 14, 0.9, 17, 1.8, 20, 3.2];
  return [
    {
      id: 'plan:route-forward', type: 'line', source: 'plan:route_legs', filter: inGear('forward'), layout: { 'line-join': 'round' },
      paint: { 'line-color': colour, 'line-width': width },
    },
    {
      id: 'plan:route-reverse', type: 'line', source: 'plan:route_legs', filter: inGear('reverse'), layout: { 'line-join': 'round' },
      paint: { 'line-color': colour, 'line-width': width, 'line-dasharray': [2, 1.5] },
    },
    {
      id: 'plan:route-ends', type: 'circle', source: 'plan:route_ends',
      paint: {
        'circle-radius': 6, 'circle-stroke-width': 2, 'circle-stroke-color': c.Rim,
        'circle-color': ['case', ['==', ['get', 'end'], 'start'], c.RouteStart, c.RouteEnd],
      },
    },
  ];
}

export function planLayers(c: Colours): { areas: LayerSpecification[]; lines: LayerSpecification[] } {
  const fill = (name: string, paint: Record<string, unknown>): LayerSpecification =>
    ({ id: `plan:${name}`, type: 'fill', source: `plan:${name}`, paint }) as LayerSpecification;
  return {
    areas: [
      fill('headland', { 'fill-color': c.Headland }),
      {
        id: 'plan:subfields', type: 'fill', source: 'plan:subfields',
        paint: { 'fill-color': ['to-color', tint(c)] as never, 'fill-antialias': true },
      },
      fill('worked', { 'fill-color': c.Covered, 'fill-opacity': 0.5 }),
      fill('given_up', { 'fill-color': c.Uncovered, 'fill-opacity': 0.45 }),
      {
        id: 'plan:swaths', type: 'fill', source: 'plan:swaths',
        paint: { 'fill-color': c.FieldEdge, 'fill-opacity': ['case', ['==', ['%', ['to-number', ['get', 'order'], 0], 2], 0], 0.16, 0.08] },
      },
      {
        id: 'plan:swaths-edge', type: 'line', source: 'plan:swaths', minzoom: 15,
        paint: { 'line-color': c.FieldEdge, 'line-opacity': 0.4, 'line-width': 0.6 },
      },
      fill('headland_unworked', { 'fill-color': c.Uncovered, 'fill-opacity': 0.85 }),
      // A rim keeps narrow pieces in sight when the whole field is.
      fill('uncovered', { 'fill-color': c.Uncovered, 'fill-outline-color': c.Uncovered }),
      fill('overlap', { 'fill-color': c.Overlap, 'fill-outline-color': c.Overlap }),
      {
        id: 'plan:outside', type: 'line', source: 'plan:outside',
        paint: { 'line-color': c.NoRoom, 'line-width': 1.5, 'line-dasharray': [2, 1.5] },
      },
      {
        id: 'plan:subfields-edge', type: 'line', source: 'plan:subfields',
        paint: { 'line-color': c.SubfieldEdge, 'line-width': 1, 'line-dasharray': [4, 3] },
      },
    ],
    lines: [
      {
        id: 'plan:headland_passes', type: 'line', source: 'plan:headland_passes', layout: { 'line-join': 'round' },
        paint: { 'line-color': c.HeadlandPass, 'line-width': thin },
      },
      {
        id: 'plan:headland_passes-arrow', type: 'symbol', source: 'plan:headland_passes',
        layout: { 'symbol-placement': 'line', 'symbol-spacing': 160, 'icon-image': 'arrow:pass', 'icon-padding': 0 },
      },
      {
        id: 'plan:dropped', type: 'line', source: 'plan:dropped',
        paint: { 'line-color': c.Dropped, 'line-width': 1.5, 'line-dasharray': [2, 2] },
      },
      {
        id: 'plan:tracks', type: 'line', source: 'plan:tracks', layout: { 'line-join': 'round' },
        paint: { 'line-color': c.Track, 'line-opacity': 0.85, 'line-width': thin },
      },
      ...routeLayers(c),
      {
        id: 'plan:detours-rim', type: 'line', source: 'plan:detours', layout: { 'line-cap': 'round', 'line-join': 'round' },
        paint: { 'line-color': c.Rim, 'line-opacity': 0.9, 'line-width': 5 },
      },
      {
        id: 'plan:detours', type: 'line', source: 'plan:detours', layout: { 'line-cap': 'round', 'line-join': 'round' },
        paint: { 'line-color': c.Detour, 'line-width': 2.4 },
      },
      {
        id: 'plan:tracks-arrow', type: 'symbol', source: 'plan:tracks', minzoom: 14,
        layout: { 'symbol-placement': 'line', 'symbol-spacing': 180, 'icon-image': 'arrow:track', 'icon-padding': 6 },
      },
      {
        id: 'plan:tracks-number', type: 'symbol', source: 'plan:tracks', minzoom: 14,
        layout: {
          'symbol-placement': 'line-center', 'icon-rotation-alignment': 'viewport', 'icon-padding': 3,
          'icon-image': ['concat', 'track:', ['to-string', ['get', 'order']]],
          // Where there is no room for all, tens and fives stay.
          'symbol-sort-key': ['case', ['==', ['%', ['to-number', ['get', 'order'], 0], 10], 0], 0, ['==', ['%', ['to-number', ['get', 'order'], 0], 5], 0], 1, 2],
        },
      },
    ],
  };
}

/** Which of the map's layers a switch of the plan turns on and off. */
export const PARTS_OF: Record<string, string[]> = {
  tracks: ['plan:tracks', 'plan:tracks-arrow', 'plan:tracks-number'],
  swaths: ['plan:swaths', 'plan:swaths-edge'],
  headland_passes: ['plan:headland_passes', 'plan:headland_passes-arrow'],
  route_legs: ['plan:route-forward', 'plan:route-reverse', 'plan:route-ends'],
  detours: ['plan:detours-rim', 'plan:detours'],
  subfields: ['plan:subfields', 'plan:subfields-edge'],
  headland: ['plan:headland'],
  worked: ['plan:worked'],
  given_up: ['plan:given_up'],
  headland_unworked: ['plan:headland_unworked'],
  uncovered: ['plan:uncovered'],
  overlap: ['plan:overlap'],
  outside: ['plan:outside'],
  dropped: ['plan:dropped'],
};
