// The map without anything on it, and which source and layer comes above which.
import type { LayerSpecification, SourceSpecification, StyleSpecification } from 'maplibre-gl';
import type { ServerInfo } from '../../api/types';
import { NIGHT, type Colours } from '../palette';
import { fieldLayers } from './field_layers';
import { planLayers } from './plan_layers';
import { workLayers } from './work_layers';
import { choosingLayers } from '../show_choosing';
import { routePlayLayers } from '../show_route_play';
import { farmLayers } from '../show_farm';
import { drawingLayers } from './drawing_layers';
import { gridLayers } from '../grid';

const empty = { type: 'FeatureCollection' as const, features: [] };

/** Sources whose features are replaced as a whole; those of work are changed tile by tile. */
export const SOURCES = [
  'grid', 'field',
  'plan:headland', 'plan:subfields', 'plan:given_up', 'plan:worked', 'plan:swaths', 'plan:headland_unworked',
  'plan:uncovered', 'plan:overlap', 'plan:outside', 'plan:headland_passes', 'plan:tracks', 'plan:route_legs', 'plan:route_ends', 'plan:detours', 'plan:dropped',
  'drive:missed', 'drive:not_recorded', 'drive:covered', 'drive:repeated', 'drive:multiplicity', 'drive:track', 'drive:gaps',
  'work:line', 'work:machine', 'drawing', 'edges', 'land', 'farm', 'farm-places', 'choosing', 'chosen', 'route-driven', 'route-machine',
] as const;
export const TILE_SOURCES = ['work:covered', 'work:repeated'] as const;

/** Tiles to show under everything; `of` says where those of the server's own file lie. */
export type Background = Pick<ServerInfo, 'tiles' | 'tiles_of'> | null;

function sources(background: Background): Record<string, SourceSpecification> {
  const all: Record<string, SourceSpecification> = {};
  for (const name of SOURCES) all[name] = { type: 'geojson', data: empty, tolerance: 0.2, maxzoom: 19 };
  for (const name of TILE_SOURCES) {
    all[name] = { type: 'geojson', data: empty, tolerance: 0, buffer: 8, maxzoom: 19 };
  }
  if (background?.tiles) {
    const { tiles, tiles_of: of } = background;
    const own = of ? { bounds: of.bbox, minzoom: of.first_zoom, maxzoom: of.last_zoom } : { maxzoom: 19 };
    all['tiles'] = { type: 'raster', tiles: [tiles.startsWith('/') ? location.origin + tiles : tiles], tileSize: 256, ...own };
  }
  return all;
}

function layers(c: Colours, tiles: boolean, night: boolean): LayerSpecification[] {
  const field = fieldLayers(c);
  const plan = planLayers(c);
  return [
    { id: 'backdrop', type: 'background', paint: { 'background-color': c.Backdrop } },
    ...(tiles ? [{ id: 'tiles', type: 'raster' as const, source: 'tiles', layout: { visibility: 'none' as const }, paint: { 'raster-brightness-max': night ? 0.55 : 1, 'raster-fade-duration': 0 } }] : []),
    ...gridLayers(c),
    ...farmLayers(c),
    ...field.below,
    ...plan.areas,
    ...workLayers(c),
    ...field.above,
    ...plan.lines,
    ...routePlayLayers(c),
    ...choosingLayers(c),
    ...drawingLayers(c),
  ];
}

export const mapStyle = (c: Colours, background: Background): StyleSpecification => ({
  version: 8,
  sources: sources(background),
  layers: layers(c, background?.tiles != null, c === NIGHT),
  transition: { duration: 0, delay: 0 },
});
