// The server, the view that is open, and the theme.
import type { ServerInfo } from '../api/types';
import { store } from './store';

export type View = 'fields' | 'plan' | 'compare' | 'review';
export type Theme = 'auto' | 'day' | 'night';

/** What the browser keeps a chosen theme under. */
export const THEME_KEY = 'tramline-theme';
const remembered = (): Theme => {
  const theme = localStorage.getItem(THEME_KEY);
  return theme === 'day' || theme === 'night' ? theme : 'auto';
};

export const session = store<{
  info: ServerInfo | null;
  reachable: boolean;
  locked: boolean;
  view: View;
  theme: Theme;
  tiles: boolean;
  /** Language and units are open to be changed. */
  settings: boolean;
}>({ info: null, reachable: true, locked: false, view: 'fields', theme: remembered(), tiles: false, settings: false });

export const dark = matchMedia('(prefers-color-scheme: dark)');
export const isNight = () => session.get().theme === 'night' || (session.get().theme === 'auto' && dark.matches);

/** Where the background comes from: "tile.example.org". */
export function tilesHost(): string {
  const tiles = session.get().info?.tiles;
  try {
    return tiles ? new URL(tiles, location.origin).host : '';
  } catch {
    return tiles ?? '';
  }
}
