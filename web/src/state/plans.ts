// Plans of the open field: the list, the one that is shown, its layers, and the job that makes the next.
import type { Check, FeatureCollection, Job, LayerItem, Machine, PlanFull, PlanItem, PlanSummary } from '../api/types';
import { store } from './store';

export const plans = store<{
  list: PlanItem[];
  open: PlanFull | null;
  /** The plan shown before: what changes are counted from. */
  before: PlanSummary | null;
  layers: LayerItem[];
  shown: Record<string, boolean>;
  shapes: Record<string, FeatureCollection>;
  /** By how much shapes on the map may deviate. */
  detail_m: number;
  /** Layers of the open plan are still on their way. */
  drawing: boolean;
  /** A field is being opened, and its plan with it. */
  coming: boolean;
  job: Job | null;
  checking: Job | null;
  checked: { plan: string; check: Check } | null;
  machines: Machine[];
}>({ list: [], open: null, before: null, layers: [], shown: {}, shapes: {}, detail_m: 0, drawing: false, coming: false, job: null, checking: null, checked: null, machines: [] });

/** On when a plan is opened; everything else is switched on by the user, and stays so. */
const FIRST_SHOWN = ['tracks', 'route_legs', 'headland_passes', 'headland', 'headland_unworked', 'detours', 'overlap', 'outside', 'uncovered', 'obstacles', 'subfields'];
export const isShown = (layer: string) => plans.get().shown[layer] ?? FIRST_SHOWN.includes(layer);
