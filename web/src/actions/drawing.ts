// Drawing a shape: from the first place to what becomes of it.
import type { Geometry, Place } from '../api/types';
import { closed, drawing, least, single, type Purpose } from '../state/drawing';
import { attempt } from './notices';

type Done = (geometry: Geometry) => Promise<void>;
let whenDone: Done = async () => {};

/** Begins to draw, and gives the map the keyboard. `done` is what becomes of the shape. */
export function drawFor(purpose: Purpose, done: Done): void {
  whenDone = done;
  drawing.set({ purpose, places: [] });
  document.querySelector<HTMLElement>('.maplibregl-canvas')?.focus({ preventScroll: true });
}

/** An edge of the field is picked instead of drawing a line. */
export const pickEdge = () => drawing.set({ purpose: 'edge', places: [] });
export const stop = () => drawing.set({ purpose: null, places: [] });

export function add(place: Place): void {
  const { purpose, places } = drawing.get();
  if (!purpose || purpose === 'edge') return;
  drawing.set({ places: single(purpose) ? [place] : [...places, place] });
}
export const undo = () => drawing.set({ places: drawing.get().places.slice(0, -1) });

function geometry(purpose: Purpose, places: Place[]): Geometry {
  if (single(purpose)) return { type: 'Point', coordinates: places[0]! };
  if (closed(purpose)) return { type: 'Polygon', coordinates: [[...places, places[0]!]] };
  return { type: 'LineString', coordinates: places };
}

export async function finish(): Promise<void> {
  const { purpose, places } = drawing.get();
  if (!purpose || purpose === 'edge' || places.length < least(purpose)) return;
  const shape = geometry(purpose, places);
  if (await attempt(() => whenDone(shape))) stop();
}
