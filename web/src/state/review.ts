// Drives: those kept by the server, the one that is open with its layers and gaps, and a log to work out.
import type { DriveFull, DriveItem, FeatureCollection, Gap, Job, Upload } from '../api/types';
import { store } from './store';

export const DRIVE_LAYERS = ['covered', 'repeated', 'missed', 'not_recorded', 'multiplicity', 'track', 'gaps'] as const;
export type DriveLayer = (typeof DRIVE_LAYERS)[number];

/** A drive has not all of them: holes of a log are rare, and files of older versions know none. */
export const hasLayer = (drive: DriveFull, name: DriveLayer): boolean =>
  name === 'not_recorded' ? (drive.summary.not_recorded_m2 ?? 0) > 0 : drive.field !== null || (name !== 'missed' && name !== 'gaps');

export const review = store<{
  list: DriveItem[] | null;
  upload: Upload | null;
  drive: DriveFull | null;
  shapes: Partial<Record<DriveLayer, FeatureCollection>>;
  shown: Record<DriveLayer, boolean>;
  job: Job | null;
  gap: Gap | null;
}>({
  list: null,
  upload: null,
  drive: null,
  shapes: {},
  shown: { covered: true, repeated: true, missed: true, not_recorded: true, multiplicity: false, track: true, gaps: true },
  job: null,
  gap: null,
});
