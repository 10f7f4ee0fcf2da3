// Getting to know the server, and noticing when it goes away and comes back.
import { api, onReach } from '../api/client';
import { ApiError } from '../api/errors';
import { session } from '../state/session';

/** `#token=…` in the address becomes a cookie that no script can read, and leaves the address. */
async function takeToken(): Promise<void> {
  const hash = new URLSearchParams(location.hash.slice(1));
  const token = hash.get('token');
  if (token === null) return;
  hash.delete('token');
  const rest = hash.toString();
  history.replaceState(null, '', location.pathname + location.search + (rest ? `#${rest}` : ''));
  await api.session(token);
}

/** Asks the server who it is; sets `locked` where it wants a token. */
export async function greet(): Promise<boolean> {
  try {
    await takeToken();
    session.set({ info: await api.info(), locked: false });
    return true;
  } catch (error) {
    if (error instanceof ApiError && (error.status === 401 || error.status === 403)) session.set({ locked: true });
    return false;
  }
}

const BEAT_MS = 4000;
const RETRY_MS = 1500;

/** Watches whether the server is there; `back` is called when it has come back. */
export function watchServer(back: () => void): void {
  onReach((reachable) => {
    const was = session.get().reachable;
    if (reachable === was) return;
    session.set({ reachable });
    if (reachable) back();
  });
  const beat = async () => {
    if (!document.hidden || !session.get().reachable) await api.info().catch(() => {});
    setTimeout(() => void beat(), session.get().reachable ? BEAT_MS : RETRY_MS);
  };
  setTimeout(() => void beat(), BEAT_MS);
}
