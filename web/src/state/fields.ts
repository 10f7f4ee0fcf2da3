// Fields: those kept by the server, the one that is open, and a file to choose from.
import type { FieldFull, FieldItem, Upload } from '../api/types';
import { store } from './store';

export const fields = store<{
  list: FieldItem[] | null;
  open: FieldFull | null;
  choosing: Upload | null;
  /** What the page is waiting for; null where it waits for nothing. */
  busy: string | null;
  /** Several fields of a file are being stored, one after the other. */
  taking: boolean;
}>({ list: null, open: null, choosing: null, busy: null, taking: false });
