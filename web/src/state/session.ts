// The server, the view that is open, and the theme.
import { api, ApiError, onReach } from '../api/client';
import type { ServerInfo } from '../api/types';
import { store } from './store';

export type View = 'fields' | 'plan' | 'compare' | 'review';
export type Theme = 'auto' | 'day' | 'night';

const THEME = 'tramline-theme';
const remembered = (): Theme => {
  const theme = localStorage.getItem(THEME);
  return theme === 'day' || theme === 'night' ? theme : 'auto';
};

export const session = store<{
  info: ServerInfo | null;
  reachable: boolean;
  locked: boolean;
  view: View;
  theme: Theme;
  tiles: boolean;
}>({ info: null, reachable: true, locked: false, view: 'fields', theme: remembered(), tiles: false });

/** Where the background comes from: "tile.example.org". */
export function tilesHost(): string {
  const tiles = session.get().info?.tiles;
  try {
    return tiles ? new URL(tiles).host : '';
  } catch {
    return tiles ?? '';
  }
}

export const show = (view: View) => session.set({ view });

const dark = matchMedia('(prefers-color-scheme: dark)');
export const isNight = () => session.get().theme === 'night' || (session.get().theme === 'auto' && dark.matches);
export function applyTheme(): void {
  document.documentElement.dataset['theme'] = isNight() ? 'night' : 'day';
}
export function setTheme(theme: Theme): void {
  localStorage.setItem(THEME, theme);
  session.set({ theme });
  applyTheme();
}
dark.addEventListener('change', () => {
  if (session.get().theme !== 'auto') return;
  applyTheme();
  session.set({ theme: 'auto' });
});

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
