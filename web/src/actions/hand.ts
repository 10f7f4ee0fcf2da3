// A hand on the plan: each change is one step to undo, is planned at once, and is held against the plan before.
import type { Geometry, Land, Place, PlanFull } from '../api/types';
import { bestOf, hand, type ByHand } from '../state/hand';
import { butForTheHand, form } from '../state/plan_form';
import { plans } from '../state/plans';
import { attempt } from './notices';
import { dropPlanning, editable, makePlan } from './planning';
import { openPlan } from './plans';

const byHand = (): ByHand => {
  const { line, shape, land } = form.get();
  return { line, shape, land };
};

const isByHand = ({ asked }: PlanFull) => Boolean(asked?.settings?.line || asked?.settings?.land?.length);

/** The plan on the map is what edits are held against, as long as nobody had a hand in it. */
function keepBest(): void {
  const { open } = plans.get();
  if (!open || isByHand(open)) return;
  if (open.summary.cut_short && hand.get().best?.field === open.field) return;
  hand.set({ best: bestOf(open, form.get()) });
}

const planned = () => {
  if (plans.get().open) void attempt(() => makePlan(true));
};

export function edit(change: Partial<ByHand>): void {
  const before = byHand();
  if (JSON.stringify({ ...before, ...change }) === JSON.stringify(before)) return;
  keepBest();
  hand.set({ past: [...hand.get().past, byHand()], future: [] });
  form.set(change);
  planned();
}

/** The form as it was; where nothing is by hand any more, the plan that was there first. */
function backTo(before: ByHand): void {
  form.set(before);
  const { best } = hand.get();
  const { open } = plans.get();
  const first = !before.line && before.land.length === 0 && best && open?.field === best.field && best.asked === butForTheHand(form.get(), best.field) ? best.plan : null;
  if (first === null || !editable(first)) return planned();
  void attempt(async () => {
    await dropPlanning();
    await openPlan(first);
  });
}

export function undoEdit(): void {
  const { past, future } = hand.get();
  const before = past[past.length - 1];
  if (!before) return;
  hand.set({ past: past.slice(0, -1), future: [byHand(), ...future] });
  backTo(before);
}

export function redoEdit(): void {
  const { past, future } = hand.get();
  const [next, ...rest] = future;
  if (!next) return;
  hand.set({ past: [...past, byHand()], future: rest });
  form.set(next);
  planned();
}

/** All steps after the first `steps` are as if they had not been. */
export function forgetEdits(steps: number): void {
  const { past } = hand.get();
  const before = past[steps];
  if (!before) return;
  hand.set({ past: past.slice(0, steps), future: [] });
  backTo(before);
}

export const addLand = (land: Land) => edit({ land: [...form.get().land, land] });
export const removeLand = (index: number) => edit({ land: form.get().land.filter((_, i) => i !== index) });

/** Tracks in this direction; the line is where the first swath begins. */
export const alongLine = (line: Place[]) => edit({ line, shape: 'straight' });

/** A part of the field whose tracks stay where they are. */
export function lockPart(geometry: Geometry, guide: Place[] | null): void {
  addLand({ kind: 'subfield', geometry, ...(guide ? { guide } : {}) });
}
