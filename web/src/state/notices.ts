// Sentences for the user: what went wrong and what to do, or what has been done.
import { store } from './store';

export interface Notice {
  number: number;
  kind: 'error' | 'note';
  text: string;
}
export const notices = store<{ list: Notice[] }>({ list: [] });
