// What the legs of a route come to, kind by kind.
import type { Leg, LegKind } from '../api/types';

export interface KindSum {
  kind: LegKind;
  legs: number;
  length_m: number;
  time_s: number;
}
const ORDER: LegKind[] = ['work', 'headland', 'turn', 'transit', 'back_out'];

/** Kinds that the route has, the work first. Together they are the whole route. */
export function sumsByKind(legs: Leg[]): KindSum[] {
  return ORDER.map((kind) => {
    const own = legs.filter((leg) => leg.kind === kind);
    const sum = (value: (leg: Leg) => number) => own.reduce((all, leg) => all + value(leg), 0);
    return { kind, legs: own.length, length_m: sum((leg) => leg.length_m), time_s: sum((leg) => leg.time_s) };
  }).filter(({ legs: count }) => count > 0);
}
