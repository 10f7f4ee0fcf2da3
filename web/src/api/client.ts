// Requests to the server. Every failure becomes an ApiError with one sentence for the user.
import { sentence } from '../format';
import { told } from '../program_words';
import { t } from '../words';
import { base } from './addresses';
import { ApiError, AWAY } from './errors';
import type * as T from './types';

type Listener = (reachable: boolean) => void;
let tell: Listener = () => {};
/** Called after every request with whether the server was reached. */
export function onReach(listener: Listener): void {
  tell = listener;
}

async function send(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<Response> {
  const init: RequestInit = { method, credentials: 'same-origin' };
  if (signal) init.signal = signal;
  if (body instanceof Blob) {
    init.body = body;
    init.headers = { 'Content-Type': 'application/octet-stream' };
  } else if (body !== undefined) {
    init.body = JSON.stringify(body);
    init.headers = { 'Content-Type': 'application/json' };
  }
  let response: Response;
  try {
    response = await fetch(base + path, init);
  } catch (error) {
    if (signal?.aborted) throw error;
    tell(false);
    throw new ApiError('away', AWAY, 0);
  }
  tell(true);
  if (!response.ok) throw await failure(response);
  return response;
}

export async function failure(response: Response): Promise<ApiError> {
  let code = 'failed';
  let message = t`The server answered with the status ${response.status}. Try again, or look at what the server prints.`;
  try {
    const answer = (await response.json()) as { error?: { code?: string; message?: string } };
    if (answer.error?.message) message = sentence(told(answer.error.message));
    if (answer.error?.code) code = answer.error.code;
  } catch {
    // No JSON: the sentence above stands.
  }
  return new ApiError(code, message, response.status);
}

/** The whole answer; one that breaks off means that the server is away, or that this page is being left. */
async function textOf(response: Response, signal?: AbortSignal): Promise<string> {
  try {
    return await response.text();
  } catch (error) {
    if (signal?.aborted) throw error;
    tell(false);
    throw new ApiError('away', AWAY, 0);
  }
}

async function json<R>(method: string, path: string, body?: unknown, signal?: AbortSignal): Promise<R> {
  const response = await send(method, path, body, signal);
  const text = await textOf(response, signal);
  return (text === '' ? undefined : JSON.parse(text)) as R;
}

const id = encodeURIComponent;

export const api = {
  info: () => json<T.ServerInfo>('GET', ''),
  addresses: () => json<{ addresses: string[] }>('GET', '/session'),
  session: (token: string) => json<void>('POST', '/session', { token }),

  upload: (file: File) => json<T.Upload>('POST', `/uploads?name=${id(file.name)}`, file),

  fields: () => json<T.FieldItem[]>('GET', '/fields'),
  field: (field: string) => json<T.FieldFull>('GET', `/fields/${id(field)}`),
  storeField: (request: Record<string, unknown>) => json<T.FieldFull>('POST', '/fields', request),
  changeField: (field: string, change: { name?: string; add?: T.ObstacleDrawn[]; remove?: number[]; boundary?: T.Geometry; crop?: string; tags?: string[] }) =>
    json<T.FieldFull>('PATCH', `/fields/${id(field)}`, change),
  deleteField: (field: string) => json<void>('DELETE', `/fields/${id(field)}`),

  machines: () => json<T.Machine[]>('GET', '/machines'),
  storeMachine: (machine: T.Machine) => json<T.Machine>('POST', '/machines', machine),
  changeMachine: (machine: string, to: T.Machine) => json<T.Machine>('PUT', `/machines/${id(machine)}`, to),
  deleteMachine: (machine: string) => json<void>('DELETE', `/machines/${id(machine)}`),

  operations: (width_m: number) => json<T.Operation[]>('GET', `/operations?width_m=${width_m}`),

  jobs: () => json<T.Job[]>('GET', '/jobs'),
  startJob: (request: T.JobRequest) => json<T.Job>('POST', '/jobs', request),
  job: (job: string) => json<T.Job>('GET', `/jobs/${id(job)}`),
  cancelJob: (job: string) => json<T.Job>('DELETE', `/jobs/${id(job)}`),

  plans: (field: string) => json<T.PlanItem[]>('GET', `/plans?field=${id(field)}`),
  plan: (plan: string) => json<T.PlanFull>('GET', `/plans/${id(plan)}`),
  renamePlan: (plan: string, name: string) => json<unknown>('PATCH', `/plans/${id(plan)}`, { name }),
  keepPlan: (plan: string) => json<unknown>('PATCH', `/plans/${id(plan)}`, { draft: false }),
  deletePlan: (plan: string) => json<void>('DELETE', `/plans/${id(plan)}`),
  planLayers: (plan: string) => json<T.LayerItem[]>('GET', `/plans/${id(plan)}/layers`),
  planLayer: (plan: string, layer: string, detail_m: number) =>
    json<T.FeatureCollection>('GET', `/plans/${id(plan)}/layers/${id(layer)}?detail_m=${detail_m}`),
  front: (front: string) => json<T.Front>('GET', `/fronts/${id(front)}`),
  layPoint: (front: string, point: number) => json<{ plan: string }>('POST', `/fronts/${id(front)}/points/${point}`),

  drives: () => json<T.DriveItem[]>('GET', '/drives'),
  storeDrive: (request: T.DriveRequest) => json<T.Job>('POST', '/drives', request),
  drive: (drive: string) => json<T.DriveFull>('GET', `/drives/${id(drive)}`),
  driveLayer: (drive: string, layer: string) => json<T.FeatureCollection>('GET', `/drives/${id(drive)}/layers/${id(layer)}`),
  renameDrive: (drive: string, name: string) => json<unknown>('PATCH', `/drives/${id(drive)}`, { name }),
  deleteDrive: (drive: string) => json<void>('DELETE', `/drives/${id(drive)}`),

  feeds: () => json<T.FeedItem[]>('GET', '/feeds'),
  startFeed: (request: T.FeedRequest) => json<T.FeedItem>('POST', '/feeds', request),
  feedWork: (feed: string, on: boolean) => json<unknown>('POST', `/feeds/${id(feed)}/work`, { on }),
  stopFeed: (feed: string) => json<{ drive: string | null }>('DELETE', `/feeds/${id(feed)}`),
};
