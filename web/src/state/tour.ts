// A short tour: what each view is for, one sentence at a time.
import type { View } from './session';
import { store } from './store';
import { t } from '../words';

export interface Stop {
  view: View;
  text: string;
}
export const STOPS: Stop[] = [
  { view: 'fields', text: t`Here are your fields. They come from a file, or you draw them; obstacles and the boundary can be changed later.` },
  { view: 'plan', text: t`Say what the machine is and what it does, then press Make the plan. You see hours, fuel and euros, and every metre of the drive.` },
  { view: 'compare', text: t`Here two plans stand side by side, and you see why the one on the map won.` },
  { view: 'review', text: t`After the work choose the log of the machine: you see what was covered, worked twice and missed, and plan what was missed.` },
];
export const tour = store<{ stop: number | null }>({ stop: null });
