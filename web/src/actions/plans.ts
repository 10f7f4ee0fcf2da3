// Plans of the open field: opening one, switching its layers, keeping, naming and deleting it.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import type { Box, FeatureCollection, PlanFull, PlanItem } from '../api/types';
import { between } from '../metres';
import { fields } from '../state/fields';
import { showAsked } from '../state/plan_form';
import { isShown, plans } from '../state/plans';

/** Plans of a field that need not be open. */
export const plansOf = (field: string): Promise<PlanItem[]> => api.plans(field);

/** The list, the latest first. */
export async function loadPlans(field: string): Promise<PlanItem[]> {
  const list = [...(await api.plans(field))].sort((a, b) => (a.created < b.created ? 1 : a.created > b.created ? -1 : 0));
  if (fields.get().open?.id === field) plans.set({ list });
  return list;
}

export function closePlan(): void {
  wanted = '';
  plans.set({ open: null, before: null, layers: [], shapes: {}, list: [] });
}

let wanted = '';

/** Opens a plan that was made before: the form shows what it was made with. */
export const openPlan = (id: string) => show(id, showAsked);

/** Shows a plan that the form has just been asked for. */
export const showPlan = (id: string) => show(id, () => {});

/** Figures come first: layers of a large plan take a while. Another plan that is opened meanwhile wins. */
async function show(id: string, figured: (plan: PlanFull) => void): Promise<void> {
  wanted = id;
  const [plan, layers] = await Promise.all([api.plan(id), api.planLayers(id)]);
  if (wanted !== id) return;
  const last = plans.get().open;
  const before = last && last.id !== id && last.field === plan.field ? last.summary : null;
  plans.set({ open: plan, before, layers, shapes: {}, drawing: true, detail_m: coarse(plan.bbox) });
  figured(plan);
  if (fields.get().open?.id !== plan.field) {
    const field = await api.field(plan.field).catch(() => null); // a deleted field's plans stay
    if (field && wanted === id) fields.set({ open: field });
  }
  const names = layers.filter((layer) => layer.features > 0 && isShown(layer.name)).map((layer) => layer.name);
  try {
    await Promise.all(names.map((name) => fetchLayer(id, name)));
  } finally {
    if (wanted === id) plans.set({ drawing: false });
  }
}

/** Shapes as fine as a screen shows a whole field: half a pixel of one that fills it. */
const SCREEN_PX = 1600;
const FINEST_M = 0.02;
function coarse([west, south, east, north]: Box): number {
  const [width_m, height_m] = between([west, south], [east, north]);
  const size_m = Math.max(width_m, height_m);
  return Math.max(FINEST_M, Math.round((100 * size_m) / SCREEN_PX) / 100);
}

/** The layers anew as fine as they are, once the map is so near that it would show. */
export async function refineLayers(): Promise<void> {
  const { open, detail_m, shapes } = plans.get();
  if (!open || detail_m <= FINEST_M) return;
  plans.set({ detail_m: FINEST_M });
  await Promise.all(Object.keys(shapes).map((name) => fetchLayer(open.id, name)));
}

async function fetchLayer(id: string, name: string): Promise<void> {
  let shape: FeatureCollection;
  const { detail_m } = plans.get();
  try {
    shape = await api.planLayer(id, name, detail_m);
  } catch (error) {
    const open = plans.get().open;
    const replaced = open?.id !== id || open.draft; // the next draft is on its way
    if ((replaced || deleted.has(id)) && error instanceof ApiError && error.status === 404) return;
    throw error;
  }
  if (plans.get().open?.id !== id) return;
  // A finer one has been asked for meanwhile, and may have come first.
  if (plans.get().detail_m < detail_m) return fetchLayer(id, name);
  plans.set({ shapes: { ...plans.get().shapes, [name]: shape } });
}

export async function switchLayer(name: string, on: boolean): Promise<void> {
  plans.set({ shown: { ...plans.get().shown, [name]: on } });
  const open = plans.get().open;
  if (on && open && !plans.get().shapes[name]) await fetchLayer(open.id, name);
}

/** Layers of these may still be on their way while the server has them no more. */
const deleted = new Set<string>();

export async function deletePlan(id: string): Promise<void> {
  deleted.add(id);
  try {
    await api.deletePlan(id);
  } catch (error) {
    deleted.delete(id);
    throw error;
  }
  const field = fields.get().open;
  if (plans.get().open?.id === id) plans.set({ open: null, before: null, layers: [], shapes: {} });
  if (field) await loadPlans(field.id);
}

async function changed(id: string, change: Partial<PlanFull>): Promise<void> {
  const open = plans.get().open;
  if (open?.id === id) plans.set({ open: { ...open, ...change } });
  const field = fields.get().open;
  if (field) await loadPlans(field.id);
}

export async function renamePlan(id: string, name: string): Promise<void> {
  await api.renamePlan(id, name);
  await changed(id, { name, draft: false });
}

/** From now on no draft replaces it. */
export async function keepPlan(id: string): Promise<void> {
  await api.keepPlan(id);
  await changed(id, { draft: false });
}
