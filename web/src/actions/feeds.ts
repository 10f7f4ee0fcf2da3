// Watching a machine that is at work.
import { api } from '../api/client';
import type { FeedItem, FeedRequest } from '../api/types';
import { fields } from '../state/fields';
import { loadDrives, openDrive } from './drives';
import { note } from './notices';
import { attach, stopReplay } from './replay';

/** The feeds that the server follows already; none where it cannot be asked. */
export const runningFeeds = (): Promise<FeedItem[]> => api.feeds().catch(() => []);

export async function watch(request: FeedRequest): Promise<void> {
  const feed = await api.startFeed(request);
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
  else note('No fix arrived, so nothing was stored. Check that the machine sends to this address, then watch it again.');
}
