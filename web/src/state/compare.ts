// The trade-off of a field, and two plans held against each other.
import type { Front, Job, PlanFull } from '../api/types';
import { store } from './store';

export const compare = store<{
  frontId: string | null;
  front: Front | null;
  field: string | null;
  job: Job | null;
  /** Plans that were laid for points of the front, so that a second click opens the same. */
  laid: Record<number, string>;
  laying: number | null;
  a: PlanFull | null;
  b: PlanFull | null;
}>({ frontId: null, front: null, field: null, job: null, laid: {}, laying: null, a: null, b: null });
