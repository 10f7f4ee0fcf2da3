// A stream of work: a log replayed at any speed, or a live feed.
import type { FixQuality, Place, WorkFigures } from '../api/types';
import { store } from './store';

export const replay = store<{
  of: 'drive' | 'feed' | null;
  id: string | null;
  name: string;
  playing: boolean;
  speed: number;
  time_s: number | null;
  from_s: number;
  to_s: number;
  fix: number;
  fixes: number;
  working: boolean;
  figures: WorkFigures | null;
  message: string | null;
  connected: boolean;
  /** The map stays over the machine. */
  follows: boolean;
  at: Place | null;
  heading_deg: number | null;
  speed_mps: number | null;
  quality: FixQuality | null;
}>({
  of: null,
  id: null,
  name: '',
  playing: false,
  speed: 20,
  time_s: null,
  from_s: 0,
  to_s: 0,
  fix: 0,
  fixes: 0,
  working: false,
  figures: null,
  message: null,
  connected: true,
  follows: true,
  at: null,
  heading_deg: null,
  speed_mps: null,
  quality: null,
});
