// What the user asks a plan for.
import type { EndRule, Machine, Place, PlanRequest, PlanSettings, Prices } from '../api/types';
import { store } from './store';

export type Shape = 'straight' | 'curved' | 'auto';

export interface PlanForm {
  machine: Machine;
  by: 'prices' | 'sliders';
  prices: Prices;
  sliders: { overlap: number; uncovered: number; turns: number };
  end_rule: EndRule;
  headlands: number;
  obstacle_headlands: number;
  shape: Shape;
  line: Place[] | null;
  clearance_m: number;
  avoid: 'cheapest' | 'cut';
  boundary: 'soft' | 'hard';
  again: boolean;
  /** The whole route, and how. Gates belong to the open field. */
  route: boolean;
  order: string;
  headland_time: 'first' | 'last';
  start: Place | null;
  end: Place | null;
}

export const USUAL: Prices = { overlap: 0.02, uncovered: 0.1, turn: 1, stop: 5, subfield: 5 };
/** The middle of a slider is the usual price; two notches double it, 0 makes the thing free. */
export const MIDDLE = 5;
export const priceAt = (notch: number, usual: number) => (notch === 0 ? 0 : usual * 2 ** ((notch - MIDDLE) / 0.75));

/** What is drawn on a field, and means nothing on another. */
export const OF_THE_FIELD = { line: null, start: null, end: null };
const KEEP = 'tramline-plan-form';
const first: PlanForm = {
  machine: { width_m: 6, radius_m: 6 },
  by: 'prices',
  prices: USUAL,
  sliders: { overlap: MIDDLE, uncovered: MIDDLE, turns: MIDDLE },
  end_rule: 'cheapest',
  headlands: 0,
  obstacle_headlands: 0,
  shape: 'straight',
  clearance_m: 0,
  avoid: 'cheapest',
  boundary: 'soft',
  again: true,
  route: false,
  order: 'best',
  headland_time: 'last',
  ...OF_THE_FIELD,
};

function kept(): PlanForm {
  try {
    const own = JSON.parse(localStorage.getItem(KEEP) ?? '{}') as Partial<PlanForm>;
    return { ...first, ...own, prices: { ...USUAL, ...own.prices }, ...OF_THE_FIELD };
  } catch {
    return first;
  }
}
export const form = store<PlanForm>(kept());
form.listen(() => localStorage.setItem(KEEP, JSON.stringify({ ...form.get(), ...OF_THE_FIELD })));

export function pricesOf(value: PlanForm): Prices {
  if (value.by === 'prices') return value.prices;
  return {
    overlap: priceAt(value.sliders.overlap, USUAL.overlap),
    uncovered: priceAt(value.sliders.uncovered, USUAL.uncovered),
    turn: priceAt(value.sliders.turns, USUAL.turn),
    stop: priceAt(value.sliders.turns, USUAL.stop),
    subfield: USUAL.subfield,
  };
}

export interface Counts {
  overlap_m2: number;
  uncovered_m2: number;
  turns: number;
  stops: number;
  further_subfields?: number;
}
/** What a plan costs at the prices of the form. Plans made for other prices are held against it by the same ones. */
export function costOf(counts: Counts, value: PlanForm = form.get()): number {
  const prices = pricesOf(value);
  return prices.overlap * counts.overlap_m2 + prices.uncovered * counts.uncovered_m2 + prices.turn * counts.turns + prices.stop * counts.stops
    + prices.subfield * (counts.further_subfields ?? 0);
}

function routeOf(value: PlanForm): PlanSettings {
  const out: PlanSettings = { route: true };
  if (value.order !== 'best') out.order = value.order;
  if (value.headland_time !== 'last') out.headland_time = value.headland_time;
  if (value.start) out.start = value.start;
  if (value.end) out.end = value.end;
  return out;
}

export function requestOf(value: PlanForm, field: string): PlanRequest {
  const settings: PlanSettings = { end_rule: value.end_rule };
  if (value.headlands > 0) settings.headlands = value.headlands;
  if (value.obstacle_headlands > 0) settings.obstacle_headlands = value.obstacle_headlands;
  if (value.shape === 'curved') settings.curved = 'always';
  if (value.shape === 'auto') settings.curved = 'auto';
  if (value.clearance_m > 0) settings.clearance_m = value.clearance_m;
  if (value.avoid !== 'cheapest') settings.avoid = value.avoid;
  if (value.boundary !== 'soft') settings.boundary = value.boundary;
  if (value.line && value.line.length > 1) {
    // A line with bends makes tracks curved; straight ones follow it from end to end.
    const [begin, end] = [value.line[0]!, value.line[value.line.length - 1]!];
    settings.line = value.shape === 'straight' ? [begin, end] : value.line;
    delete settings.curved;
  }
  if (value.route) Object.assign(settings, routeOf(value));
  const { name, width_m, radius_m, min_length_m, turning } = value.machine;
  const machine: Machine = { width_m, radius_m };
  if (name) machine.name = name;
  if (typeof min_length_m === 'number') machine.min_length_m = min_length_m;
  if (turning) machine.turning = turning;
  return { field, machine, objective: { prices: pricesOf(value) }, settings };
}
