// What was done to plans by hand, so that it can be undone, and what the plan before it cost.
import type { Rates } from '../api/types';
import type { PlanForm } from './plan_form';
import { store } from './store';

/** The part of the form that a hand on the plan changes. */
export type ByHand = Pick<PlanForm, 'line' | 'shape' | 'land'>;

/** The plan that nobody had a hand in. */
export interface Best {
  field: string;
  euros: number | null;
  rates: Rates | null;
  counts: { overlap_m2: number; uncovered_m2: number; turns: number; stops: number };
}

export const hand = store<{ past: ByHand[]; future: ByHand[]; best: Best | null }>({ past: [], future: [], best: null });
