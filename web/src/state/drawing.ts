// A shape being drawn, by clicks on the map, by keys, or by coordinates.
import type { Place } from '../api/types';
import { store } from './store';

export type Purpose = 'field' | 'boundary' | 'obstacle-point' | 'obstacle-line' | 'obstacle-area' | 'obstacle-shape' | 'guide' | 'edge' | 'gate' | 'direction' | 'skip' | 'exempt' | 'subfield' | 'cut' | 'lock';
export const drawing = store<{
  purpose: Purpose | null;
  places: Place[];
  /** The corner that Delete takes away. */
  chosen: number | null;
  /** What Undo and Redo go to. */
  past: Place[][];
  future: Place[][];
  /** Whether the last place was set by pointing: then Enter is done, else it sets the next one. */
  pointed: boolean;
}>({ purpose: null, places: [], chosen: null, past: [], future: [], pointed: false });

/** Whether it is a single place, which each click sets anew. */
export const single = (purpose: Purpose | null) => purpose === 'obstacle-point' || purpose === 'gate';
/** How many places a shape needs at least. */
export const least = (purpose: Purpose) =>
  single(purpose) ? 1 : closed(purpose) ? 3 : 2;
const CLOSED: readonly (Purpose | null)[] = ['field', 'boundary', 'obstacle-area', 'obstacle-shape', 'skip', 'exempt', 'subfield', 'lock'];
export const closed = (purpose: Purpose | null) => CLOSED.includes(purpose);
/** Two ends that are there from the start, and are only moved. */
export const fixedEnds = (purpose: Purpose | null) => purpose === 'direction';
