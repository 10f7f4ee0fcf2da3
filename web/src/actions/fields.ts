// Opening, storing and changing fields, and taking them from files.
import { api } from '../api/client';
import { ApiError } from '../api/errors';
import type { FieldFull, Geometry, ObstacleDrawn, Upload, UploadedFeature } from '../api/types';
import { plural, sentence } from '../format';
import { calledField, fields } from '../state/fields';
import { hand } from '../state/hand';
import { form, OF_THE_FIELD } from '../state/plan_form';
import { plans } from '../state/plans';
import { review } from '../state/review';
import { attempt, complain, note } from './notices';
import { takeUpPlanning } from './planning';
import { closePlan, loadPlans, openPlan } from './plans';
import { asOne, busy, uploadFile } from './files/upload';
import { told } from '../program_words';
import { t } from '../words';

export async function loadFields(): Promise<void> {
  fields.set({ list: await api.fields() });
}

/** Opens a field with the plan named, or else with its last one. */
async function opened(field: FieldFull, plan: string | null = null): Promise<void> {
  if (fields.get().open?.id !== field.id) {
    closePlan();
    form.set(OF_THE_FIELD);
    hand.set({ past: [], future: [], best: null });
    if (review.get().drive?.field !== field.id) review.set({ drive: null });
  }
  plans.set({ coming: true });
  fields.set({ open: field });
  try {
    const list = await loadPlans(field.id);
    const wanted = plan ?? plans.get().open?.id ?? list[0]?.id;
    // What an address names may be gone by now: then the field simply opens without it.
    if (wanted && wanted !== plans.get().open?.id) await openPlan(wanted).catch(() => {});
  } finally {
    plans.set({ coming: false });
  }
  void attempt(() => takeUpPlanning(field.id));
}

export const openField = (id: string, plan: string | null = null) => busy(t`Opening the field …`, async () => opened(await api.field(id), plan));

/** A file of one field opens it; one of several asks which. */
export async function takeFieldFile(files: File[]): Promise<void> {
  const upload = await uploadFile(await asOne(files));
  await takeFields(upload);
}

/** The fields of a file that was sent: of a task set with logs those that it has beside them. */
export async function takeFields(sent: Upload): Promise<void> {
  const partfields = sent.kind === 'log' ? (sent.partfields ?? []) : [];
  const upload: Upload = partfields.length > 0 ? { ...sent, kind: 'fields', features: partfields, features_total: partfields.length } : sent;
  if (upload.kind !== 'fields') {
    const what = upload.kind === 'log' ? t`the log of a machine: drop it under Review` : upload.kind === 'plan' ? t`a plan, not a field: choose the file of the field itself` : null;
    throw new ApiError(
      'bad_input',
      what ? t`${upload.name} is ${what}.` : t`${upload.name} contains no field. Choose a GeoJSON, GeoPackage, Shapefile, KML or ISOXML file. ${sentence(told(upload.message ?? ''))}`.trim(),
      400,
    );
  }
  const features = upload.features ?? [];
  const only = features[0];
  if (features.length === 1 && only && only.refused === null) await takeFeature(upload, only);
  else fields.set({ choosing: upload });
}

const LONGEST = 80;
const storeFeature = (upload: Upload, { fid, layer, name, crop }: UploadedFeature) =>
  api.storeField({ upload: upload.id, fid, ...(layer === undefined ? {} : { layer }), ...(name ? { name: name.slice(0, LONGEST) } : {}), ...(crop ? { crop: crop.slice(0, LONGEST) } : {}) });

let stopped = false;
export const stopTaking = () => void (stopped = true);

/** Stores them in turn, without opening any. What cannot be stored is reported, and the others are stored all the same. */
export async function takeFeatures(upload: Upload, features: UploadedFeature[]): Promise<void> {
  const [only] = features;
  if (features.length === 1 && only) return takeFeature(upload, only);
  stopped = false;
  fields.set({ taking: true });
  let stored = 0;
  const refused: string[] = [];
  try {
    for (const feature of features) {
      if (stopped) break;
      fields.set({ busy: t`Storing ${calledField(feature)}, ${stored + refused.length + 1} of ${features.length} …` });
      try {
        await storeFeature(upload, feature);
        stored++;
      } catch (error) {
        if (!(error instanceof ApiError) || error.away) throw error;
        refused.push(`${calledField(feature)}: ${error.message}`);
      }
    }
  } finally {
    fields.set({ busy: null, taking: false, ...(stopped ? {} : { choosing: null }) });
    await loadFields();
  }
  note(t`Stored: ${plural(stored, 'field')} of ${upload.name}${stopped ? t`; you stopped the others` : ''}. Open one under Your fields.`);
  if (refused.length > 0) complain(t`Could not be stored: ${plural(refused.length, 'field')}. ${refused.slice(0, 3).join(' ')}`);
}

/** Stores every field of a file that can be used, and opens the first. */
export async function storeAll(upload: Upload): Promise<void> {
  const stored: string[] = [];
  for (const feature of upload.features ?? []) if (feature.refused === null) stored.push((await storeFeature(upload, feature)).id);
  await loadFields();
  const [first] = stored;
  if (first) await opened(await api.field(first));
}

export async function takeFeature(upload: Upload, feature: UploadedFeature): Promise<void> {
  const field = await busy(t`Checking the field …`, () => storeFeature(upload, feature));
  fields.set({ choosing: null });
  await opened(await api.field(field.id));
  await loadFields();
}

export async function storeDrawnField(name: string, geometry: Geometry): Promise<void> {
  const field = await busy(t`Checking the field …`, () => api.storeField({ name, geometry }));
  await opened(await api.field(field.id));
  await loadFields();
}

export async function changeField(change: { name?: string; add?: ObstacleDrawn[]; remove?: number[]; boundary?: Geometry; crop?: string; tags?: string[] }): Promise<void> {
  const open = fields.get().open;
  if (!open) return;
  await api.changeField(open.id, change);
  fields.set({ open: await api.field(open.id) });
  if (change.add || change.remove || change.boundary) {
    closePlan(); // it was made for other land
    await loadPlans(open.id);
  }
  await loadFields();
}

export async function deleteField(id: string): Promise<void> {
  await api.deleteField(id);
  if (fields.get().open?.id === id) {
    closePlan();
    fields.set({ open: null });
  }
  await loadFields();
  note(t`The field is deleted. Its drives are still under Review, and its plans are still in the server’s folder.`);
}
