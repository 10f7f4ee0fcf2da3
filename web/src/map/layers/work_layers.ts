// What was worked: of a drive that is over, and of one that goes on.
import type { LayerSpecification } from 'maplibre-gl';
import type { Colours } from '../palette';

/** As in the library's pictures: so many gaps bear a number from afar. */
const GAPS_NUMBERED = 12;

export function workLayers(c: Colours): LayerSpecification[] {
  // Tiles meet edge to edge: smoothed edges would show as seams.
  const ground = (id: string, color: string, opacity: number, antialias: boolean): LayerSpecification => ({
    id, type: 'fill', source: id, paint: { 'fill-color': color, 'fill-opacity': opacity, 'fill-antialias': antialias },
  });
  return [
    ground('drive:covered', c.Covered, 1, true),
    ground('drive:missed', c.Uncovered, 0.9, true),
    ground('drive:not_recorded', c.NotRecorded, 0.9, true),
    ground('drive:repeated', c.Overlap, 0.9, true),
    {
      id: 'drive:multiplicity', type: 'fill', source: 'drive:multiplicity',
      paint: {
        'fill-color': ['match', ['to-number', ['get', 'times'], 1], 1, c.Covered, 2, c.Overlap, c.TwiceHatch],
        'fill-opacity': 0.85,
      },
    },
    ground('work:covered', c.Covered, 1, false),
    ground('work:repeated', c.Overlap, 1, false),
    {
      id: 'drive:track', type: 'line', source: 'drive:track', filter: ['!=', ['get', 'run'], null],
      paint: { 'line-color': c.WorkedPath, 'line-opacity': 0.7, 'line-width': 1 },
    },
    {
      id: 'drive:track-idle', type: 'line', source: 'drive:track', filter: ['==', ['get', 'run'], null],
      paint: { 'line-color': c.IdlePath, 'line-opacity': 0.8, 'line-width': 1, 'line-dasharray': [3, 3] },
    },
    { id: 'work:line', type: 'line', source: 'work:line', paint: { 'line-color': c.WorkedPath, 'line-width': 1.4 } },
    {
      id: 'drive:gaps', type: 'line', source: 'drive:gaps',
      paint: { 'line-color': c.Uncovered, 'line-width': ['case', ['<=', ['to-number', ['get', 'number'], 99], GAPS_NUMBERED], 2.5, 1] },
    },
    {
      id: 'drive:gaps-number', type: 'symbol', source: 'drive:gaps',
      filter: ['any', ['<=', ['to-number', ['get', 'number'], 99], GAPS_NUMBERED], ['>=', ['zoom'], 17.5]] as never,
      layout: {
        'icon-image': ['concat', 'gap:', ['to-string', ['get', 'number']]], 'icon-padding': 2,
        'symbol-sort-key': ['to-number', ['get', 'number'], 99],
      },
    },
    {
      id: 'work:machine', type: 'symbol', source: 'work:machine',
      layout: {
        'icon-image': ['concat', 'machine:', ['get', 'work']], 'icon-rotate': ['get', 'heading'],
        'icon-rotation-alignment': 'map', 'icon-allow-overlap': true, 'icon-ignore-placement': true,
      },
    },
  ];
}

export const DRIVE_PARTS: Record<string, string[]> = {
  covered: ['drive:covered'],
  repeated: ['drive:repeated'],
  missed: ['drive:missed'],
  not_recorded: ['drive:not_recorded'],
  multiplicity: ['drive:multiplicity'],
  track: ['drive:track', 'drive:track-idle'],
  gaps: ['drive:gaps', 'drive:gaps-number'],
};
