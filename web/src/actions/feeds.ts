// Watching a machine that is at work.
import { api } from '../api/client';
import { follow } from '../api/jobs';
import type { FeedItem, FeedRequest } from '../api/types';
import { fields } from '../state/fields';
import { loadDrives, openDrive } from './drives';
import { note } from './notices';
import { attach, stopReplay } from './play/replay';
import { t } from '../words';

/** The feeds that the server follows already; none where it cannot be asked. */
export const runningFeeds = (): Promise<FeedItem[]> => api.feeds().catch(() => []);

/** How the machine that is watched was asked for, by the feed's id, so that it can be asked for again. */
const KEEP = 'tramline-feed';
const keep = (id: string, request: FeedRequest) => sessionStorage.setItem(KEEP, JSON.stringify({ id, request }));
function kept(id: string): FeedRequest | null {
  const one = JSON.parse(sessionStorage.getItem(KEEP) ?? 'null') as { id: string; request: FeedRequest } | null;
  return one?.id === id ? one.request : null;
}

export async function watch(request: FeedRequest): Promise<void> {
  const feed = await api.startFeed(request);
  keep(feed.id, request);
  const { field } = request;
  if (field && fields.get().open?.id !== field) fields.set({ open: await api.field(field) });
  attach(feed);
}

/** Says in the machine's place whether it works. */
export const switchWork = (feed: string, on: boolean) => api.feedWork(feed, on);

/** Ends a feed; what came of it is opened as a drive. */
export async function endFeed(feed: string): Promise<void> {
  const { drive } = await api.stopFeed(feed);
  stopReplay();
  await loadDrives();
  if (drive) await openDrive(drive);
  else note(t`No fix arrived, so nothing was stored. Check that the machine sends to this address, then watch it again.`);
}

/** Work that a server takes up after its start appears among the drives when it is there. */
export async function awaitTakenUp(): Promise<void> {
  const going = (await api.jobs()).filter((job) => job.kind === 'evaluate' && (job.state === 'queued' || job.state === 'running'));
  for (const job of going) await follow(job, () => {}).catch(() => {});
  await loadDrives();
}

/** The server was started again: what the machine had worked till then is a drive, and the machine is read anew. */
export async function readAgain(feed: FeedItem): Promise<void> {
  const request = kept(feed.id);
  stopReplay();
  await awaitTakenUp();
  note(t`${feed.name ?? t`The machine`}: the server was started again. What was worked till then is stored as a drive.${request ? t` The machine is being watched again.` : ''}`);
  if (request) await watch(request);
}
