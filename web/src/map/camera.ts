// Moving the map: to a box, to a place, nearer and farther.
import type { Map as GlMap } from 'maplibre-gl';
import type { Box, Place } from '../api/types';

const calm = matchMedia('(prefers-reduced-motion: reduce)');

/** Moves the map so that a box fills it, less what lies over it. */
export function fit(map: GlMap, box: Box): void {
  const wide = map.getContainer().clientWidth > 760;
  const padding = wide ? { top: 48, bottom: 56, left: 48, right: 360 } : { top: 20, bottom: 44, left: 62, right: 20 };
  map.fitBounds(box, { padding, maxZoom: 20, animate: !calm.matches, duration: 500 });
}

/** Moves the map so that a place can be seen from near. */
export function look(map: GlMap, at: Place, size_m: number): void {
  const span = Math.max(size_m, 10) * 2.5;
  const lat = span / 111_000;
  const lon = lat / Math.max(0.01, Math.cos((at[1] * Math.PI) / 180));
  fit(map, [at[0] - lon, at[1] - lat, at[0] + lon, at[1] + lat]);
}

export function zoomBy(map: GlMap, steps: number): void {
  const zoom = map.getZoom() + steps;
  if (calm.matches) map.jumpTo({ zoom });
  else map.easeTo({ zoom, duration: 200 });
}
