// What was done to plans by hand, so that it can be undone, and what the plan before it cost.
import type { PlanFull, Rates } from '../api/types';
import { butForTheHand, type PlanForm } from './plan_form';
import { store } from './store';

/** The part of the form that a hand on the plan changes. */
export type ByHand = Pick<PlanForm, 'line' | 'shape' | 'land'>;

/** The plan that nobody had a hand in: what edits begin from, and are held against. */
export interface Best {
  field: string;
  plan: string;
  /** What the form says but for what is done by hand (butForTheHand). */
  asked: string;
  euros: number | null;
  rates: Rates | null;
  counts: { overlap_m2: number; uncovered_m2: number; turns: number; stops: number };
}

export function bestOf({ id, field, summary: { whole_cost, overlap_m2, uncovered_m2, turns, stops } }: PlanFull, asked: PlanForm): Best {
  return {
    field, plan: id, asked: butForTheHand(asked, field),
    euros: whole_cost?.euros ?? null, rates: whole_cost?.rates ?? null, counts: { overlap_m2, uncovered_m2, turns, stops },
  };
}

export const hand = store<{ past: ByHand[]; future: ByHand[]; best: Best | null }>({ past: [], future: [], best: null });
