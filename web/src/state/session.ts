// The server, the view that is open, and the theme.
import type { ServerInfo } from '../api/types';
import { store } from './store';
import { looksLike, remembered, type Theme } from './theme';

export type View = 'fields' | 'plan' | 'compare' | 'review';

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

export const isNight = () => looksLike(session.get().theme) === 'night';

/** Where the background comes from: "tile.example.org". */
export function tilesHost(): string {
  const tiles = session.get().info?.tiles;
  try {
    return tiles ? new URL(tiles, location.origin).host : '';
  } catch {
    return tiles ?? '';
  }
}
