// A shape being drawn, by clicks on the map, by keys, or by coordinates.
import type { Place } from '../api/types';
import { store } from './store';

export type Purpose = 'field' | 'obstacle-point' | 'obstacle-line' | 'obstacle-area' | 'guide' | 'edge';
export const drawing = store<{ purpose: Purpose | null; places: Place[] }>({ purpose: null, places: [] });

export const least = (purpose: Purpose) =>
  purpose === 'obstacle-point' ? 1 : purpose === 'guide' || purpose === 'obstacle-line' ? 2 : 3;
export const closed = (purpose: Purpose | null) => purpose === 'field' || purpose === 'obstacle-area';

export const begin = (purpose: Purpose) => drawing.set({ purpose, places: [] });
export const stop = () => drawing.set({ purpose: null, places: [] });
export function add(place: Place): void {
  const { purpose, places } = drawing.get();
  if (!purpose || purpose === 'edge') return;
  drawing.set({ places: purpose === 'obstacle-point' ? [place] : [...places, place] });
}
export const undo = () => drawing.set({ places: drawing.get().places.slice(0, -1) });
export function finished(): boolean {
  const { purpose, places } = drawing.get();
  return purpose !== null && purpose !== 'edge' && places.length >= least(purpose);
}
