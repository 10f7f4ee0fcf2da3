// Drives: taking a log, working out what it covered, and opening, naming and deleting what came of it.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import { follow } from '../api/jobs';
import type { DriveFull, DriveOptions, Job, Upload } from '../api/types';
import { sentence } from '../format';
import { fields } from '../state/fields';
import { DRIVE_LAYERS, hasLayer, review, type DriveLayer } from '../state/review';
import { loadFields, takeFields } from './fields';
import { note } from './notices';
import { stopReplay } from './play/replay';
import { show } from './session';
import { asOne, uploadFile } from './files/upload';
import { told } from '../program_words';
import { t } from '../words';

export async function loadDrives(): Promise<void> {
  const list = await api.drives();
  review.set({ list: [...list].sort((a, b) => (a.created < b.created ? 1 : a.created > b.created ? -1 : 0)) });
}

export async function takeLogFile(files: File[]): Promise<void> {
  const upload = await uploadFile(await asOne(files));
  const nothingDriven = upload.kind === 'log' && (upload.logs ?? []).every((log) => log.fixes === 0) && (upload.partfields ?? []).length > 0;
  if (upload.kind === 'fields' || nothingDriven) {
    // A task set without logs is no mistake: its fields open.
    show('fields');
    note(t`${upload.name} has no log. Its fields are here.`);
    return takeFields(upload);
  }
  if (upload.kind !== 'log') {
    const what = upload.kind === 'plan' ? t`a plan, not a log: choose the file that the machine wrote` : null;
    throw new ApiError(
      'bad_input',
      what ? t`${upload.name} is ${what}.` : t`${upload.name} is not the log of a machine. Choose a CSV, NMEA, GPX or ISOXML file. ${sentence(told(upload.message ?? ''))}`.trim(),
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
  options: DriveOptions;
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
    ...(Object.keys(chosen.options).length === 0 ? {} : { options: chosen.options }),
  });
  const drive = await finish(job);
  review.set({ upload: null });
  if (drive) await openDrive(drive);
  await Promise.all([loadDrives(), loadFields()]);
}

/** The same log once more, with other options in the place of those that it has. */
export async function evaluateAgain(drive: DriveFull, options: DriveOptions): Promise<void> {
  stopReplay();
  try {
    const job = await api.startJob({ kind: 'evaluate', drive: drive.id, options });
    await follow(job, (state) => review.set({ job: state }));
    await openDrive(drive.id); // before the job goes from the page, so that old figures do not come back
  } finally {
    review.set({ job: null });
  }
  await loadDrives();
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
