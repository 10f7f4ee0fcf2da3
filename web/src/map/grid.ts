// The metre grid under everything, and the scale bar.
import type { GeoJSONSource, LayerSpecification, Map as GlMap } from 'maplibre-gl';
import type { Feature, Place } from '../api/types';
import { between, degreeLengths, moved, roundStep_m } from '../metres';
import type { Colours } from './palette';

const LEAST_PX = 64;

export const gridLayers = (c: Colours): LayerSpecification[] => [
  {
    id: 'grid', type: 'line', source: 'grid',
    paint: { 'line-color': ['case', ['get', 'strong'], c.GridStrong, c.Grid], 'line-width': 1 },
  },
];

const line = (from: Place, to: Place, strong: boolean): Feature => ({
  type: 'Feature', properties: { strong }, geometry: { type: 'LineString', coordinates: [from, to] },
});

function metresPerPixel(map: GlMap): number {
  // MapLibre's world is 512 px wide at zoom 0.
  return (degreeLengths(map.getCenter().lat)[0] * 360) / (512 * 2 ** map.getZoom());
}

/** Draws the lines for what is in sight, counted from `origin`; every fifth is stronger. Gives their step. */
export function drawGrid(map: GlMap, origin: Place): number {
  const step = roundStep_m(metresPerPixel(map) * LEAST_PX);
  const bounds = map.getBounds();
  const [w, s] = between(origin, [bounds.getWest(), bounds.getSouth()]);
  const [e, n] = between(origin, [bounds.getEast(), bounds.getNorth()]);
  const features: Feature[] = [];
  const many = Math.max((e - w) / step, (n - s) / step);
  if (many < 100) {
    for (let i = Math.floor(w / step) - 1; i * step <= e + step; i++) {
      features.push(line(moved(origin, i * step, s - step), moved(origin, i * step, n + step), i % 5 === 0));
    }
    for (let i = Math.floor(s / step) - 1; i * step <= n + step; i++) {
      features.push(line(moved(origin, w - step, i * step), moved(origin, e + step, i * step), i % 5 === 0));
    }
  }
  void (map.getSource('grid') as GeoJSONSource).setData({ type: 'FeatureCollection', features } as never);
  return step;
}

/** The scale bar: a round length, how wide it is on the screen, and how far apart lines of the grid are. */
export interface Scale {
  length_m: number;
  width_px: number;
  grid_m: number;
}

export function scaleOf(map: GlMap): Pick<Scale, 'length_m' | 'width_px'> {
  const perPixel = metresPerPixel(map);
  const length_m = roundStep_m(perPixel * 70);
  return { length_m, width_px: length_m / perPixel };
}
