// Fields: those kept by the server, the one that is open, and a file to choose from.
import type { FieldFull, FieldItem, Upload, UploadedFeature } from '../api/types';
import { store } from './store';

export const fields = store<{
  list: FieldItem[] | null;
  open: FieldFull | null;
  choosing: Upload | null;
  /** Fields of the file that are found by what is typed, and those that are ticked, as the map shows them. */
  found: UploadedFeature[];
  ticked: ReadonlySet<string>;
  pointed: string | null;
  /** The one that was clicked on the map, which the list shows. */
  reached: string | null;
  /** What the page is waiting for; null where it waits for nothing. */
  busy: string | null;
  /** Several fields of a file are being stored, one after the other. */
  taking: boolean;
}>({ list: null, open: null, choosing: null, found: [], ticked: new Set(), pointed: null, reached: null, busy: null, taking: false });

/** What people call a field of a file. */
export const calledField = (feature: UploadedFeature) => feature.name || feature.id;
export const keyOf = (feature: UploadedFeature) => `${feature.layer ?? ''}/${feature.fid}`;
