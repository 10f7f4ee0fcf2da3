// A hand on the plan: each change is one step to undo, is planned at once, and is held against the plan before.
import type { Geometry, Land, Place } from '../api/types';
import { hand, type ByHand } from '../state/hand';
import { form } from '../state/plan_form';
import { plans } from '../state/plans';
import { attempt } from './notices';
import { makePlan } from './planning';

const byHand = (): ByHand => {
  const { line, shape, land } = form.get();
  return { line, shape, land };
};

/** The plan on the map is what edits are held against, as long as nobody had a hand in it. */
function keepBest(): void {
  const { open } = plans.get();
  if (!open || open.asked?.settings?.line || open.asked?.settings?.land?.length) return;
  const { best } = hand.get();
  if (open.summary.cut_short && best?.field === open.field) return;
  const { whole_cost, overlap_m2, uncovered_m2, turns, stops } = open.summary;
  hand.set({ best: { field: open.field, euros: whole_cost?.euros ?? null, rates: whole_cost?.rates ?? null, counts: { overlap_m2, uncovered_m2, turns, stops } } });
}

/** Where changes of a plan do not plan by themselves, this does. */
function planned(): void {
  if (form.get().again || !plans.get().open) return;
  void attempt(() => makePlan(true));
}

export function edit(change: Partial<ByHand>): void {
  const before = byHand();
  if (JSON.stringify({ ...before, ...change }) === JSON.stringify(before)) return;
  keepBest();
  hand.set({ past: [...hand.get().past, byHand()], future: [] });
  form.set(change);
  planned();
}

export function undoEdit(): void {
  const { past, future } = hand.get();
  const before = past[past.length - 1];
  if (!before) return;
  hand.set({ past: past.slice(0, -1), future: [byHand(), ...future] });
  form.set(before);
  planned();
}

export function redoEdit(): void {
  const { past, future } = hand.get();
  const [next, ...rest] = future;
  if (!next) return;
  hand.set({ past: [...past, byHand()], future: rest });
  form.set(next);
  planned();
}

export const addLand = (land: Land) => edit({ land: [...form.get().land, land] });
export const removeLand = (index: number) => edit({ land: form.get().land.filter((_, i) => i !== index) });

/** Tracks in this direction; the line is where the first swath begins. */
export const alongLine = (line: Place[]) => edit({ line, shape: 'straight' });

/** A part of the field whose tracks stay where they are. */
export function lockPart(geometry: Geometry, guide: Place[] | null): void {
  addLand({ kind: 'subfield', geometry, ...(guide ? { guide } : {}) });
}
