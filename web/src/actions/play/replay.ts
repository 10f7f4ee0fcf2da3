// Running a stream of work. Frames go to whoever draws them; the figures go into the store.
import { feedEvents, replayEvents } from '../../api/addresses';
import { api } from '../../api/client';
import { AWAY } from '../../api/errors';
import { openStream, type Stream } from '../../api/event_stream';
import type { DriveFull, FeedItem, Place, WorkFigures, WorkFrame } from '../../api/types';
import { distance } from '../../metres';
import { replay } from '../../state/replay';
import { complain } from '../notices';
import { t } from '../../words';

type Draw = (frame: WorkFrame | null) => void;
let draw: Draw = () => {};
/** `draw` gets every frame, and null where the map is to be cleared. */
export function onFrame(drawer: Draw): void {
  draw = drawer;
}

let stream: Stream | null = null;
function shut(): void {
  stream?.close();
  stream = null;
}

/** By the last two frames; as before where they are too near in time. */
function speedBetween(last: { at: Place | null; time_s: number | null; speed_mps: number | null }, now: WorkFrame): number | null {
  if (!last.at || !now.at || last.time_s === null || now.time_s === null) return null;
  const passed_s = now.time_s - last.time_s;
  if (passed_s < 0.05) return passed_s < 0 ? null : last.speed_mps;
  return distance(last.at, now.at) / passed_s;
}

function take(frame: WorkFrame): void {
  draw(frame);
  const { time_s, fix, fixes, working, figures, at, heading_deg, quality = null } = frame;
  const speed_mps = speedBetween(replay.get(), frame);
  replay.set({ time_s, fix, fixes, working, figures, at, heading_deg, speed_mps, quality });
}

const times = (drive: DriveFull) => {
  const from_s = drive.from_s ?? 0;
  return { from_s, to_s: drive.to_s ?? from_s + Math.max(1, drive.summary.fixes) };
};

/** Begins, or goes on, to replay a drive. `only` shows the state at that moment and stands still. */
function run(drive: string, at_s: number, only: boolean): void {
  shut();
  draw(null);
  replay.set({ playing: !only, time_s: at_s });
  const frame = (data: WorkFrame) => {
    take(data);
    if (only) shut();
  };
  const end = (data: { figures?: WorkFigures }) => {
    shut();
    replay.set({ playing: false, ...(data.figures ? { figures: data.figures } : {}) });
    if (!only) replay.set({ time_s: replay.get().to_s });
  };
  stream = openStream(replayEvents(drive, at_s, only ? 0.1 : replay.get().speed), { frame, end }, () => {
    shut();
    if (!replay.get().playing) return;
    replay.set({ playing: false });
    complain(t`The replay was interrupted. Press Play to continue from here.`);
  });
}

export function play(drive: DriveFull): void {
  const { from_s, to_s } = times(drive);
  const going = replay.get().of === 'drive' && replay.get().id === drive.id;
  const at = going ? (replay.get().time_s ?? from_s) : from_s;
  replay.set({ of: 'drive', id: drive.id, name: drive.name, from_s, to_s, message: null, connected: true });
  run(drive.id, at >= to_s ? from_s : at, false);
}

export function pause(): void {
  shut();
  replay.set({ playing: false });
}

export function seek(drive: DriveFull, to: number): void {
  const { from_s, to_s } = times(drive);
  const playing = replay.get().playing;
  replay.set({ of: 'drive', id: drive.id, name: drive.name, from_s, to_s });
  run(drive.id, to, !playing);
}

export function setSpeed(speed: number): void {
  replay.set({ speed });
  const { playing, id, time_s, of } = replay.get();
  if (playing && of === 'drive' && id && time_s !== null) run(id, time_s, false);
}

export function attach(feed: FeedItem): void {
  shut();
  draw(null);
  replay.set({
    of: 'feed', id: feed.id, name: feed.name ?? feed.source ?? feed.id, playing: true, figures: null, time_s: null,
    fix: 0, fixes: 0, message: null, connected: true, at: null, speed_mps: null, quality: null,
  });
  const frame = (data: WorkFrame) => take(data);
  const state = (data: { message: string; connected: boolean }) => replay.set({ message: data.message, connected: data.connected });
  const end = () => shut();
  stream = openStream(feedEvents(feed.id), { frame, state, end }, () => {
    shut();
    replay.set({ connected: false, message: AWAY });
    retry(feed);
  });
}

const RETRY_MS = 2000;
function retry(feed: FeedItem): void {
  setTimeout(() => {
    const { of, id, connected } = replay.get();
    if (of === 'feed' && id === feed.id && !connected && !stream) void attachAgain(feed);
  }, RETRY_MS);
}

let lost: (feed: FeedItem) => Promise<void> = async () => {};
/** `gone` is called where the server has come back without the feed. */
export const onLostFeed = (gone: (feed: FeedItem) => Promise<void>) => void (lost = gone);

async function attachAgain(feed: FeedItem): Promise<void> {
  const list = await api.feeds().catch(() => null);
  if (list === null) return retry(feed); // it is not back yet
  if (list.some((one) => one.id === feed.id)) attach(feed);
  else await lost(feed);
}

/** Leaves replay or feed; a feed goes on in the server. */
export function stopReplay(): void {
  shut();
  draw(null);
  replay.set({ of: null, id: null, playing: false, time_s: null, figures: null, message: null });
}
