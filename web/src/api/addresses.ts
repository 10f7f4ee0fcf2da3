// Addresses on the server that are followed rather than asked for: files to download, and streams.

export const base = '/api/v1';
const id = encodeURIComponent;
// Two centimetres are less than a screen shows, and a day's work is a third of the bytes.
const SEEN = 'detail_m=0.02';

export function planFile(plan: string, format: string, query: Record<string, string | number> = {}): string {
  const words = Object.entries(query).map(([key, value]) => `${key}=${id(value)}`).join('&');
  return `${base}/plans/${id(plan)}/files/${format}${words ? `?${words}` : ''}`;
}
/** A small picture, which leaves a draft a draft. */
export const planThumbnail = (plan: string) => `${base}/plans/${id(plan)}/thumbnail`;
export const driveFile = (drive: string, format: string) => `${base}/drives/${id(drive)}/files/${format}`;

export const jobEvents = (job: string) => `${base}/jobs/${id(job)}/events`;
export const feedEvents = (feed: string) => `${base}/feeds/${id(feed)}/events?${SEEN}`;
export const replayEvents = (drive: string, from_s: number | null, speed: number) =>
  `${base}/drives/${id(drive)}/replay?speed=${speed}&${SEEN}${from_s === null ? '' : `&from_s=${from_s}`}`;
