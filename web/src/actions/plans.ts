// Plans of the open field: opening one, switching its layers, keeping, naming and deleting it.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import type { FeatureCollection, PlanFull, PlanItem } from '../api/types';
import { fields } from '../state/fields';
import { isShown, plans } from '../state/plans';

/** Plans of a field that need not be open. */
export const plansOf = (field: string): Promise<PlanItem[]> => api.plans(field);

export async function loadPlans(field: string): Promise<void> {
  const list = await api.plans(field);
  plans.set({ list: [...list].sort((a, b) => (a.created < b.created ? 1 : a.created > b.created ? -1 : 0)) });
}

export function closePlan(): void {
  plans.set({ open: null, before: null, layers: [], shapes: {}, list: [] });
}

let wanted = '';

export async function openPlan(id: string): Promise<void> {
  wanted = id;
  const [plan, layers] = await Promise.all([api.plan(id), api.planLayers(id)]);
  const names = layers.filter((layer) => layer.features > 0 && isShown(layer.name)).map((layer) => layer.name);
  const shapes = await fetchLayers(id, names);
  if (wanted !== id) return; // another one was opened meanwhile
  const last = plans.get().open;
  const before = last && last.id !== id && last.field === plan.field ? last.summary : null;
  plans.set({ open: plan, before, layers, shapes });
  if (fields.get().open?.id !== plan.field) {
    const field = await api.field(plan.field).catch(() => null); // a deleted field's plans stay
    if (field) fields.set({ open: field });
  }
}

async function fetchLayers(id: string, names: string[]): Promise<Record<string, FeatureCollection>> {
  const shapes = await Promise.all(names.map(async (name) => [name, await api.planLayer(id, name)] as const));
  return Object.fromEntries(shapes);
}

export async function switchLayer(name: string, on: boolean): Promise<void> {
  plans.set({ shown: { ...plans.get().shown, [name]: on } });
  const open = plans.get().open;
  if (!on || !open || plans.get().shapes[name]) return;
  const fetched = await fetchLayers(open.id, [name]).catch((error: unknown) => {
    if (open.draft && error instanceof ApiError && error.status === 404) return null; // the next draft is on its way
    throw error;
  });
  if (fetched && plans.get().open?.id === open.id) plans.set({ shapes: { ...plans.get().shapes, ...fetched } });
}

export async function deletePlan(id: string): Promise<void> {
  await api.deletePlan(id);
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
