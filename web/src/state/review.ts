// Drives: those kept by the server, the one that is open, its replay or the live feed, and the repair.
import { api, ApiError, sentence } from '../api/client';
import { follow } from '../api/jobs';
import type { DriveFull, DriveItem, FeatureCollection, FeedRequest, Gap, Job, Upload } from '../api/types';
import { assertSize, busy, fields, loadFields } from './fields';
import { note } from './notices';
import { form } from './plan_form';
import { openPlan } from './plans';
import { stopReplay } from './replay';
import { show } from './session';
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

export async function loadDrives(): Promise<void> {
  const list = await api.drives();
  review.set({ list: [...list].sort((a, b) => (a.created < b.created ? 1 : a.created > b.created ? -1 : 0)) });
}

export async function takeLogFile(file: File): Promise<void> {
  assertSize(file);
  const upload = await busy(`Reading ${file.name} …`, () => api.upload(file));
  if (upload.kind !== 'log') {
    const what = upload.kind === 'fields' ? 'a file of fields: drop it under Fields' : upload.kind === 'plan' ? 'a plan, not a log: choose the file that the machine wrote' : null;
    throw new ApiError(
      'bad_input',
      what ? `${file.name} is ${what}.` : `${file.name} is no log of a machine. Choose a CSV, NMEA, GPX or ISOXML file. ${sentence(upload.message ?? '')}`.trim(),
      400,
    );
  }
  review.set({ upload });
}

export interface DriveForm {
  log: string | null;
  field: string | null;
  plan: string | null;
  width_m: number | null;
}

async function finish(job: Job): Promise<string | null> {
  try {
    const result = await follow(job, (state) => review.set({ job: state }));
    return result.drive ?? null;
  } finally {
    review.set({ job: null });
  }
}

export async function evaluate(upload: Upload, chosen: DriveForm): Promise<void> {
  const job = await api.storeDrive({
    upload: upload.id,
    ...(chosen.log === null ? {} : { log: chosen.log }),
    ...(chosen.field === null ? {} : { field: chosen.field }),
    ...(chosen.plan === null ? {} : { plan: chosen.plan }),
    ...(chosen.width_m === null ? {} : { width_m: chosen.width_m }),
  });
  const drive = await finish(job);
  review.set({ upload: null });
  if (drive) await openDrive(drive);
  await Promise.all([loadDrives(), loadFields()]);
}

export async function cancelReview(): Promise<void> {
  const job = review.get().job;
  if (job) await api.cancelJob(job.id);
}

export async function openDrive(id: string): Promise<void> {
  stopReplay();
  const drive = await api.drive(id);
  if (drive.field && fields.get().open?.id !== drive.field) {
    const field = await api.field(drive.field).catch(() => null); // a deleted field's drives stay
    fields.set({ open: field });
  }
  const names = DRIVE_LAYERS.filter((name) => review.get().shown[name] && (name !== 'not_recorded' || hasLayer(drive, name)));
  const shapes = await fetchShapes(id, names);
  review.set({ drive, shapes, gap: null });
}

async function fetchShapes(id: string, names: readonly DriveLayer[]) {
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, await api.driveLayer(id, name)] as const)));
}

export async function switchDriveLayer(name: DriveLayer, on: boolean): Promise<void> {
  review.set({ shown: { ...review.get().shown, [name]: on } });
  const drive = review.get().drive;
  if (!on || !drive || review.get().shapes[name]) return;
  const fetched = await fetchShapes(drive.id, [name]);
  if (review.get().drive?.id === drive.id) review.set({ shapes: { ...review.get().shapes, ...fetched } });
}

export async function renameDrive(id: string, name: string): Promise<void> {
  await api.renameDrive(id, name);
  const open = review.get().drive;
  if (open?.id === id) review.set({ drive: { ...open, name } });
  await loadDrives();
}

export async function deleteDrive(id: string): Promise<void> {
  await api.deleteDrive(id);
  if (review.get().drive?.id === id) {
    stopReplay();
    review.set({ drive: null, shapes: {}, gap: null });
  }
  await loadDrives();
}

/** The repair plan of the open drive's gaps, shown in the plan view. */
export async function planTheGaps(least_m2: number): Promise<void> {
  const drive = review.get().drive;
  if (!drive) return;
  const { width_m, radius_m } = form.get().machine;
  try {
    const job = await api.startJob({ kind: 'repair', drive: drive.id, machine: { width_m, radius_m }, min_area_m2: least_m2 });
    const result = await follow(job, (state) => review.set({ job: state }));
    if (!result.plan) return;
    stopReplay();
    await openPlan(result.plan);
    show('plan');
    note('This is the plan for what was missed. Take it away as a file, or go back to Review.');
  } finally {
    review.set({ job: null });
  }
}

export const startFeed = (request: FeedRequest) => api.startFeed(request);
