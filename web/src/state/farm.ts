// Several fields at once: those that are ticked, and how far planning them is.
import { store } from './store';

export const farm = store<{
  ticked: ReadonlySet<string>;
  planning: { done: number; of: number; failed: string[] } | null;
}>({ ticked: new Set(), planning: null });
