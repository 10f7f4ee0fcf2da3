// Drawing a shape: from the first place to what becomes of it.
import type { Geometry, Place } from '../api/types';
import { closed, drawing, fixedEnds, least, single, type Purpose } from '../state/drawing';
import { attempt } from './notices';

type Done = (geometry: Geometry) => Promise<void>;
let whenDone: Done = async () => {};
let whenChanged: (places: Place[]) => void = () => {};
let whenCancelled: () => void = () => {};

interface Begin {
  /** A shape that is there already. */
  places?: Place[];
  /** Called at the end of each change, before the shape is done. */
  changed?: (places: Place[]) => void;
  /** Called where the shape is not wanted after all. */
  cancelled?: () => void;
}

const NOTHING = { chosen: null, past: [], future: [], pointed: false };

/** What had the focus when drawing began. */
let opener: Element | null = null;
function giveMapTheKeyboard(): void {
  if (drawing.get().purpose === null) opener = document.activeElement;
  document.querySelector<HTMLElement>('.maplibregl-canvas')?.focus({ preventScroll: true });
}
/** Back to what drawing began from, unless the user has gone on to something else. */
function takeKeyboardBack(): void {
  const there = document.activeElement;
  if (there !== document.body && !there?.closest('.map')) return;
  if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
}

/** Begins to draw, and gives the map the keyboard, or the slider that turns the line; `done` is what becomes of the shape. */
export function drawFor(purpose: Purpose, done: Done, { places = [], changed = () => {}, cancelled = () => {} }: Begin = {}): void {
  whenDone = done;
  whenChanged = changed;
  whenCancelled = cancelled;
  giveMapTheKeyboard();
  drawing.set({ ...NOTHING, purpose, places });
}

/** An edge of the field is picked instead of drawing a line. */
export function pickEdge(): void {
  giveMapTheKeyboard();
  drawing.set({ ...NOTHING, purpose: 'edge', places: [] });
}
export function stop(): void {
  takeKeyboardBack();
  drawing.set({ ...NOTHING, purpose: null, places: [] });
}
/** Stops, and takes back what changes have done already. */
export function cancel(): void {
  const { purpose } = drawing.get();
  stop();
  if (purpose && purpose !== 'edge') whenCancelled();
}

function change(places: Place[], more: { chosen?: number | null; pointed?: boolean } = {}): void {
  const { past, places: before } = drawing.get();
  drawing.set({ chosen: null, ...more, places, past: [...past, before], future: [] });
}

/** The next place; `by` says whether it was pointed at. */
export function add(place: Place, by: 'pointer' | 'keys' = 'keys'): void {
  const { purpose, places } = drawing.get();
  if (!purpose || purpose === 'edge' || fixedEnds(purpose)) return;
  change(single(purpose) ? [place] : [...places, place], { pointed: by === 'pointer' });
}

/** A corner between two others: after the one of this number. */
export function insert(after: number, place: Place): void {
  const { places } = drawing.get();
  change([...places.slice(0, after + 1), place, ...places.slice(after + 1)], { chosen: after + 1, pointed: true });
}

export function choose(corner: number | null): void {
  drawing.set({ chosen: corner });
}

/** A corner on its way; the whole way is one step for Undo. */
export function move(corner: number, place: Place): void {
  const { places } = drawing.get();
  drawing.set({ places: places.map((old, i) => (i === corner ? place : old)), chosen: corner });
}
export function moved(before: Place[]): void {
  const { past, places } = drawing.get();
  if (JSON.stringify(places) === JSON.stringify(before)) return;
  drawing.set({ past: [...past, before], future: [], pointed: true });
  whenChanged(drawing.get().places);
}

/** The whole shape on its way, as moved() ends it. */
export function reshape(places: Place[]): void {
  drawing.set({ places, chosen: null });
}

/** The chosen corner goes, or the last one. */
export function removeCorner(): void {
  const { chosen, places, purpose } = drawing.get();
  if (fixedEnds(purpose)) return;
  const at = chosen ?? places.length - 1;
  if (places[at]) change(places.filter((_, i) => i !== at));
}

export function undo(): void {
  const { past, future, places } = drawing.get();
  const before = past[past.length - 1];
  if (!before) return;
  drawing.set({ places: before, past: past.slice(0, -1), future: [places, ...future], chosen: null });
  whenChanged(before);
}
export function redo(): void {
  const { past, future, places } = drawing.get();
  const [next, ...rest] = future;
  if (!next) return;
  drawing.set({ places: next, past: [...past, places], future: rest, chosen: null });
  whenChanged(next);
}

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
