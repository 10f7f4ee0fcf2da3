// What the user asks a plan for.
import type { Asked, EndRule, Land, Machine, Place, PlanFull, PlanRequest, PlanSettings, Prices } from '../api/types';
import { landPrices } from './rates';
import { store } from './store';
import { t } from '../words';

export type Shape = 'straight' | 'curved' | 'auto';
/** What plans are compared by: the whole job at the rates of the machine, or tracks alone at prices of their own. */
export type By = 'whole' | 'prices' | 'sliders';
/** A number of headland passes, or as many as turns need. */
export type Passes = number | 'auto';

/** What differs between plans of the whole job and of tracks alone where nobody has chosen. */
interface Usual {
  headlands: Passes;
  obstacle_headlands: Passes;
  shape: Shape;
  boundary: 'soft' | 'hard';
  route: boolean;
}
const WHOLE: Usual = { headlands: 'auto', obstacle_headlands: 'auto', shape: 'auto', boundary: 'hard', route: true };
const TRACKS: Usual = { headlands: 0, obstacle_headlands: 0, shape: 'straight', boundary: 'soft', route: false };

export interface PlanForm extends Usual {
  machine: Machine;
  by: By;
  prices: Prices;
  sliders: { overlap: number; uncovered: number; turns: number };
  end_rule: EndRule;
  line: Place[] | null;
  /** Drawn on the open field for its plans. */
  land: Land[];
  clearance_m: number;
  avoid: 'cheapest' | 'cut';
  again: boolean;
  /** How the whole route is driven. Gates belong to the open field. */
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
export const OF_THE_FIELD: Pick<PlanForm, 'line' | 'start' | 'end' | 'land'> = { line: null, start: null, end: null, land: [] };
const KEEP = 'tramline-plan-form-2';
const first: PlanForm = {
  machine: { width_m: 6, radius_m: 6 },
  by: 'whole',
  prices: USUAL,
  sliders: { overlap: MIDDLE, uncovered: MIDDLE, turns: MIDDLE },
  end_rule: 'cheapest',
  clearance_m: 0,
  avoid: 'cheapest',
  again: true,
  order: 'best',
  headland_time: 'last',
  ...WHOLE,
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

/** From the whole job to tracks alone or back: what is usual there takes the place of what was usual here. */
export function planBy(by: By): void {
  const value = form.get();
  const [from, to] = [value.by === 'whole' ? WHOLE : TRACKS, by === 'whole' ? WHOLE : TRACKS];
  const change: Partial<PlanForm> = { by };
  for (const key of Object.keys(to) as (keyof Usual)[]) if (value[key] === from[key]) Object.assign(change, { [key]: to[key] });
  // Tracks alone have no turns that would tell how many passes they need.
  if (by !== 'whole') for (const key of ['headlands', 'obstacle_headlands'] as const) if (value[key] === 'auto') change[key] = 0;
  form.set(change);
}

export function pricesOf(value: PlanForm): Prices {
  if (value.by !== 'sliders') return value.prices;
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
/** What the tracks of a plan cost at the prices of the form. Plans made for other prices are held against it by the same ones. */
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

const CURVED: Record<Shape, 'never' | 'always' | 'auto'> = { straight: 'never', curved: 'always', auto: 'auto' };

function settingsOf(value: PlanForm): PlanSettings {
  const settings: PlanSettings = {
    end_rule: value.end_rule, headlands: value.headlands, obstacle_headlands: value.obstacle_headlands, boundary: value.boundary, curved: CURVED[value.shape],
  };
  if (value.clearance_m > 0) settings.clearance_m = value.clearance_m;
  if (value.avoid !== 'cheapest') settings.avoid = value.avoid;
  if (value.line && value.line.length > 1) {
    // A line with bends makes tracks curved; straight ones follow it from end to end.
    const [begin, end] = [value.line[0]!, value.line[value.line.length - 1]!];
    settings.line = value.shape === 'straight' ? [begin, end] : value.line;
    delete settings.curved;
  }
  if (value.land.length > 0) settings.land = value.land;
  return Object.assign(settings, value.by === 'whole' || value.route ? routeOf(value) : { route: false });
}

/** Land that need not be worked is taken off the field: then tracks alone are planned, since headland passes go round a whole one. */
function planned(value: PlanForm): PlanForm {
  if (!value.land.some(({ kind }) => kind === 'done')) return value;
  const whole = value.by === 'whole';
  return {
    ...value, headlands: 0, obstacle_headlands: 0, route: false,
    ...(whole ? { by: 'prices' as const, prices: landPrices(value.machine.rates, USUAL), shape: 'straight' as const } : {}),
  };
}

export function requestOf(asked: PlanForm, field: string): PlanRequest {
  const value = planned(asked);
  const { name, width_m, radius_m, min_length_m, turning, rates } = value.machine;
  const machine: Machine = { width_m, radius_m };
  if (name) machine.name = name;
  if (typeof min_length_m === 'number') machine.min_length_m = min_length_m;
  if (turning) machine.turning = turning;
  if (rates && Object.keys(rates).length > 0) machine.rates = rates;
  return { field, machine, settings: settingsOf(value), ...(value.by === 'whole' ? {} : { objective: { prices: pricesOf(value) } }) };
}

/** What a request says but for what is done by hand. */
export function butForTheHand(value: PlanForm, field: string): string {
  const { name: _, ...machine } = value.machine;
  return JSON.stringify(requestOf({ ...value, machine, line: null, land: [], shape: 'auto' }, field));
}

/** A comparison takes straight tracks in directions of its own, and as many headland passes as it is told. */
export interface CompareRequest {
  request: PlanRequest;
  /** What it does otherwise than the form says, in words. */
  instead: string[];
}

/** Passes that are left to turns are as many as the plan on the map has all round. */
export function compareRequestOf(value: PlanForm, field: string, passes: number, land: Prices = value.prices): CompareRequest {
  const instead: string[] = [];
  if (value.by === 'whole') instead.push(t`Tracks are compared by themselves, without the way between them.`);
  if (value.land.length > 0) instead.push(t`It is of the whole field, without what was done by hand.`);
  if (value.line) instead.push(t`Tracks go in every direction, not only along the line that is chosen.`);
  if (value.shape !== 'straight') instead.push(t`All tracks are straight.`);
  const settle = (asked: Passes, usual: number) => {
    if (asked !== 'auto') return asked;
    instead.push(usual === 0 ? t`No headland passes go round the field.` : t`Headland passes round the field: ${usual}.`);
    return usual;
  };
  const tracks: PlanForm = {
    ...value, by: value.by === 'whole' ? 'prices' : value.by, prices: value.by === 'whole' ? land : value.prices, route: false, shape: 'straight', line: null, land: [],
    headlands: settle(value.headlands, passes),
    obstacle_headlands: value.obstacle_headlands === 'auto' ? 0 : value.obstacle_headlands,
  };
  const request = requestOf(tracks, field);
  delete request.settings.curved;
  return { request, instead };
}

const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);
const shapeOf = (curved: string | undefined, usual: Shape): Shape => (Object.keys(CURVED) as Shape[]).find((shape) => CURVED[shape] === curved) ?? usual;

/** What the form says of a request, so that the next one is like it but for what is changed. */
function asAsked({ machine, objective, settings = {} }: Asked, value: PlanForm): Partial<PlanForm> {
  const usual = objective ? TRACKS : WHOLE;
  const by: By = !objective ? 'whole' : same(objective.prices, pricesOf({ ...value, by: 'sliders' })) ? 'sliders' : 'prices';
  const bends = (settings.line?.length ?? 0) > 2;
  return {
    machine: { ...machine, ...(same({ ...value.machine, id: undefined }, machine) && value.machine.id ? { id: value.machine.id } : {}) },
    by,
    ...(objective && by === 'prices' ? { prices: { ...USUAL, ...objective.prices } } : {}),
    end_rule: settings.end_rule ?? 'cheapest',
    headlands: settings.headlands ?? usual.headlands,
    obstacle_headlands: settings.obstacle_headlands ?? usual.obstacle_headlands,
    boundary: settings.boundary ?? usual.boundary,
    route: settings.route ?? usual.route,
    shape: settings.line ? (bends ? 'curved' : 'straight') : shapeOf(settings.curved, usual.shape),
    clearance_m: settings.clearance_m ?? 0,
    avoid: settings.avoid === 'cut' ? 'cut' : 'cheapest',
    line: settings.line ?? null,
    land: settings.land ?? [],
    order: settings.order ?? 'best',
    headland_time: settings.headland_time ?? 'last',
    start: settings.start ?? null,
    end: settings.end ?? null,
  };
}

let showing = false;
/** Whether the form changes because a plan was opened, not because the user asks for another one. */
export const isShowing = () => showing;

/** The form shows what the plan was made with; of plans that nobody asked for by a form, what machine they are for. */
export function showAsked(plan: PlanFull): void {
  const value = form.get();
  const { width_m, radius_m } = plan.summary;
  showing = true;
  try {
    if (plan.asked) form.set(asAsked(plan.asked, value));
    else if (value.machine.width_m !== width_m || value.machine.radius_m !== radius_m) form.set({ machine: { ...value.machine, width_m, radius_m } });
  } finally {
    showing = false;
  }
}
