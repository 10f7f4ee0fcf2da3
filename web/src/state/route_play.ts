// A route driven on the screen: where the machine is at a moment, and what it has taken till then.
import type { FeatureCollection, Place, PlanFull } from '../api/types';
import { store } from './store';

export const routePlay = store<{ plan: string | null; at_s: number; playing: boolean; speed: number }>({ plan: null, at_s: 0, playing: false, speed: 60 });

const HOUR_S = 3600;

export interface SoFar {
  /** The leg of that moment, by its place in the route. */
  leg: number;
  /** The part of it that is driven. */
  share: number;
  litres: number;
  /** Machine, driver and fuel. */
  euros: number;
}

/** What the route has taken after so many seconds. */
export function soFar({ summary: { route, whole_cost: cost }, idle_fuel_share }: PlanFull, at_s: number): SoFar {
  let [passed, working] = [0, 0];
  let leg = 0;
  let share = 0;
  const legs = route?.legs ?? [];
  for (; leg < legs.length; leg++) {
    const { time_s, work } = legs[leg]!;
    const part = Math.min(time_s, at_s - passed);
    passed += part;
    if (work) working += part;
    share = time_s > 0 ? part / time_s : 1;
    if (share < 1) break;
  }
  const rates = cost?.rates;
  const litres = rates ? (rates.fuel_l_per_h * (working + idle_fuel_share * (passed - working))) / HOUR_S : 0;
  return { leg: Math.min(leg, legs.length - 1), share, litres, euros: rates ? (rates.price_per_hour * passed) / HOUR_S + litres * rates.fuel_price : 0 };
}

/** The way of each leg; legs without length have none. */
export function waysOf(shapes: FeatureCollection | undefined, legs: number): Place[][] {
  const out: Place[][] = Array.from({ length: legs }, () => []);
  for (const { geometry, properties } of shapes?.features ?? []) {
    const at = Number(properties['seq']) - 1;
    if (geometry && out[at]) out[at] = geometry.type === 'MultiLineString' ? (geometry.coordinates as Place[][]).flat() : (geometry.coordinates as Place[]);
  }
  return out;
}
