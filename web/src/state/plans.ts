// Plans of the open field: the list, the one that is shown, its layers, and the job that makes the next.
import { api, ApiError } from '../api/client';
import { follow } from '../api/jobs';
import type { Check, FeatureCollection, Job, LayerItem, Machine, PlanFull, PlanItem } from '../api/types';
import { fields } from './fields';
import { attempt } from './notices';
import { form, requestOf } from './plan_form';
import { store } from './store';

export interface Figures {
  overlap_m2: number;
  uncovered_m2: number;
  turns: number;
  stops: number;
  cost: number;
}

export const plans = store<{
  list: PlanItem[];
  open: PlanFull | null;
  /** The plan shown before: what changes are counted from. */
  before: Figures | null;
  layers: LayerItem[];
  shown: Record<string, boolean>;
  shapes: Record<string, FeatureCollection>;
  job: Job | null;
  checking: Job | null;
  checked: { plan: string; check: Check } | null;
  machines: Machine[];
}>({ list: [], open: null, before: null, layers: [], shown: {}, shapes: {}, job: null, checking: null, checked: null, machines: [] });

/** On when a plan is opened; everything else is switched on by the user, and stays so. */
export const FIRST_SHOWN = ['tracks', 'headland_passes', 'headland', 'headland_unworked', 'detours', 'overlap', 'uncovered', 'obstacles', 'subfields'];
export const isShown = (layer: string) => plans.get().shown[layer] ?? FIRST_SHOWN.includes(layer);

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

let run = 0;

/** Makes a plan as the form says, which the next one replaces if it is a draft; a run that is still going on is cancelled first. */
export async function makePlan(draft = false): Promise<void> {
  const field = fields.get().open;
  if (!field) return;
  const mine = ++run;
  const going = plans.get().job;
  if (going) await api.cancelJob(going.id).catch(() => {});
  try {
    const job = await api.startJob({ kind: 'plan', ...requestOf(form.get(), field.id), explain: true, ...(draft ? { draft } : {}) });
    const result = await follow(job, (state) => mine === run && plans.set({ job: state }));
    if (mine !== run || !result.plan) return;
    await openPlan(result.plan);
    await loadPlans(field.id);
  } catch (error) {
    if (mine === run) throw error;
  } finally {
    if (mine === run) plans.set({ job: null });
  }
}

export async function cancelPlan(): Promise<void> {
  const job = plans.get().job;
  if (job) await api.cancelJob(job.id);
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

/** Works the plan out anew on the server, by another road than the one that made it. */
export async function checkPlan(id: string): Promise<void> {
  try {
    const { check } = await follow(await api.startJob({ kind: 'check', plan: id }), (job) => plans.set({ checking: job }));
    if (check) plans.set({ checked: { plan: id, check } });
  } finally {
    plans.set({ checking: null });
  }
}
export async function cancelCheck(): Promise<void> {
  const job = plans.get().checking;
  if (job) await api.cancelJob(job.id);
}

export async function loadMachines(): Promise<void> {
  plans.set({ machines: await api.machines() });
}

const PAUSE_MS = 350;
let timer = 0;

/** What a plan comes out by: the name of a machine changes nothing. */
function whatMatters(field: string): string {
  const { machine: { name: _, ...machine }, ...rest } = requestOf(form.get(), field);
  return JSON.stringify({ ...rest, machine });
}

/** Once a plan is there, changes of the form make the next one by themselves. */
export function planAtChanges(): void {
  let last = '';
  form.listen(() => {
    const field = fields.get().open;
    const asked = field ? whatMatters(field.id) : '';
    if (asked === last) return;
    last = asked;
    clearTimeout(timer);
    const open = plans.get().open;
    if (!form.get().again || !field || !open || open.field !== field.id) return;
    timer = window.setTimeout(() => void attempt(() => makePlan(true)), PAUSE_MS);
  });
}
