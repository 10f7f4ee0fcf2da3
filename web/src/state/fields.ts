// Fields: those kept by the server, the one that is open, and a file to choose from.
import { api, ApiError, sentence } from '../api/client';
import type { FieldFull, FieldItem, Geometry, ObstacleDrawn, Upload, UploadedFeature } from '../api/types';
import { megabytes } from '../format';
import { review } from './review';
import { closePlan, loadPlans } from './plans';
import { note } from './notices';
import { session } from './session';
import { store } from './store';

export const fields = store<{
  list: FieldItem[] | null;
  open: FieldFull | null;
  choosing: Upload | null;
  busy: string | null;
}>({ list: null, open: null, choosing: null, busy: null });

export async function loadFields(): Promise<void> {
  fields.set({ list: await api.fields() });
}

/** While `what` is being done the view says so. */
export async function busy<R>(what: string, action: () => Promise<R>): Promise<R> {
  fields.set({ busy: what });
  try {
    return await action();
  } finally {
    fields.set({ busy: null });
  }
}

async function opened(field: FieldFull): Promise<void> {
  if (fields.get().open?.id !== field.id) {
    closePlan();
    if (review.get().drive?.field !== field.id) review.set({ drive: null });
  }
  fields.set({ open: field });
  await loadPlans(field.id);
}

export const openField = (id: string) => busy('Opening the field …', async () => opened(await api.field(id)));

export function assertSize(file: File): void {
  const limit = session.get().info?.limits.upload_bytes;
  if (limit !== undefined && file.size > limit) {
    throw new ApiError(
      'too_large',
      `${file.name} has ${megabytes(file.size)}, and at most ${megabytes(limit)} are taken. Cut it into smaller files, or zip it.`,
      413,
    );
  }
  if (file.size === 0) throw new ApiError('bad_input', `${file.name} is empty. Choose another file.`, 400);
}

/** A file of one field opens it; one of several asks which. */
export async function takeFieldFile(file: File): Promise<void> {
  assertSize(file);
  const upload = await busy(`Reading ${file.name} …`, () => api.upload(file));
  if (upload.kind !== 'fields') {
    const what = upload.kind === 'log' ? 'the log of a machine: drop it under Review' : upload.kind === 'plan' ? 'a plan, not a field' : null;
    throw new ApiError(
      'bad_input',
      what ? `${file.name} is ${what}.` : `${file.name} holds no field. Choose a GeoJSON, GeoPackage, Shapefile, KML or ISOXML file. ${sentence(upload.message ?? '')}`.trim(),
      400,
    );
  }
  const features = upload.features ?? [];
  const only = features[0];
  if (features.length === 1 && only && only.refused === null) await takeFeature(upload, only);
  else fields.set({ choosing: upload });
}

export async function takeFeature(upload: Upload, feature: UploadedFeature): Promise<void> {
  const request: Record<string, unknown> = { upload: upload.id, fid: feature.fid };
  if (feature.layer !== undefined) request['layer'] = feature.layer;
  const field = await busy('Looking over the field …', () => api.storeField(request));
  fields.set({ choosing: null });
  await opened(await api.field(field.id));
  await loadFields();
}

export async function storeDrawnField(name: string, geometry: Geometry): Promise<void> {
  const field = await busy('Looking over the field …', () => api.storeField({ name, geometry }));
  await opened(await api.field(field.id));
  await loadFields();
}

export async function changeField(change: { name?: string; add?: ObstacleDrawn[]; remove?: number[] }): Promise<void> {
  const open = fields.get().open;
  if (!open) return;
  await api.changeField(open.id, change);
  fields.set({ open: await api.field(open.id) });
  if (change.add || change.remove) closePlan(); // it was made for other ground
  await loadFields();
}

export async function deleteField(id: string): Promise<void> {
  await api.deleteField(id);
  if (fields.get().open?.id === id) {
    closePlan();
    fields.set({ open: null });
  }
  await loadFields();
  note('The field is deleted. Its plans and drives are kept.');
}
