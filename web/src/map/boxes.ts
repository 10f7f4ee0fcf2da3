// How boxes in longitude and latitude lie to one another.
import type { Box, FieldItem, Place } from '../api/types';

const EARTH_M = 6_371_009;
const rad = (deg: number) => (deg * Math.PI) / 180;

/** What two boxes share, in square degrees; 0 where they only touch, or are apart. */
export const shared = (a: Box, b: Box) =>
  Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));

/** Between the nearest places of two spans of a scale. */
function nearest(low: number, high: number, otherLow: number, otherHigh: number): [number, number] {
  if (high < otherLow) return [high, otherLow];
  if (otherHigh < low) return [low, otherHigh];
  const both = Math.max(low, otherLow);
  return [both, both];
}

/** How far apart two boxes are, m, on a sphere; 0 where they touch. */
export function apart_m(a: Box, b: Box): number {
  const [lon1, lon2] = nearest(a[0], a[2], b[0], b[2]);
  const [lat1, lat2] = nearest(a[1], a[3], b[1], b[3]);
  const h = Math.sin(rad(lat2 - lat1) / 2) ** 2 + Math.cos(rad(lat1)) * Math.cos(rad(lat2)) * Math.sin(rad(lon2 - lon1) / 2) ** 2;
  return 2 * EARTH_M * Math.asin(Math.min(1, Math.sqrt(h)));
}

/** What all boxes lie in; null where there is none. */
const around = (list: Box[]): Box | null =>
  list.length === 0 ? null : list.reduce((all, box) => [Math.min(all[0], box[0]), Math.min(all[1], box[1]), Math.max(all[2], box[2]), Math.max(all[3], box[3])]);
export const farmBox = (list: FieldItem[]): Box | null => around(list.map(({ bbox }) => bbox));
export const boxOf = (places: Place[]): Box | null => around(places.map(([x, y]) => [x, y, x, y]));
