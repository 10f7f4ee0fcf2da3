// Metres about a place, for what is drawn on the screen: grid, scale bar, drawing by metres. Good to a part
// in a thousand over a few kilometres; the library's own planes are what counts.
import type { Place } from './api/types';
import { unitOf } from './measures';

const A = 6378137;
const E2 = 0.00669437999014;
const RAD = Math.PI / 180;

/** Metres in a degree of longitude and of latitude, on WGS 84. */
export function degreeLengths(lat: number): [lon_m: number, lat_m: number] {
  const w = 1 - E2 * Math.sin(lat * RAD) ** 2;
  return [(RAD * A * Math.cos(lat * RAD)) / Math.sqrt(w), (RAD * A * (1 - E2)) / w ** 1.5];
}

export function moved(from: Place, east_m: number, north_m: number): Place {
  const [lon_m, lat_m] = degreeLengths(from[1]);
  return [from[0] + east_m / lon_m, from[1] + north_m / lat_m];
}

export function between(from: Place, to: Place): [east_m: number, north_m: number] {
  const [lon_m, lat_m] = degreeLengths((from[1] + to[1]) / 2);
  return [(to[0] - from[0]) * lon_m, (to[1] - from[1]) * lat_m];
}

export const distance = (from: Place, to: Place) => Math.hypot(...between(from, to));

/** Degrees clockwise from north, in [0, 360). */
export function bearing(from: Place, to: Place): number {
  const [east, north] = between(from, to);
  return ((Math.atan2(east, north) / RAD) % 360 + 360) % 360;
}

/** The direction of a line, which has no front: degrees clockwise from north, in [0, 180). */
export const directionOf = (line: Place[]) => bearing(line[0]!, line[line.length - 1]!) % 180;

/** A line of two ends about its middle, turned the shorter way until its direction is `deg`. */
export function turnedTo([from, to]: Place[], deg: number): Place[] {
  const [east, north] = between(from!, to!);
  const by = ((((deg - directionOf([from!, to!])) % 180) + 270) % 180 - 90) * RAD;
  const middle: Place = [(from![0] + to![0]) / 2, (from![1] + to![1]) / 2];
  const [x, y] = [(east * Math.cos(by) + north * Math.sin(by)) / 2, (north * Math.cos(by) - east * Math.sin(by)) / 2];
  return [moved(middle, -x, -y), moved(middle, x, y)];
}

/** The line, so far to the right as one looks along it. */
export function shifted(line: Place[], right_m: number): Place[] {
  const [east, north] = between(line[0]!, line[line.length - 1]!);
  const long = Math.hypot(east, north);
  return line.map((place) => moved(place, (north / long) * right_m, (-east / long) * right_m));
}

/** 1, 2 or 5 times a power of ten of the reader's metres or feet, at least `least_m`. */
export function roundStep_m(least_m: number): number {
  const { size } = unitOf('m');
  return roundStep(least_m / size) * size;
}

function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((step) => step >= least) ?? 10 * power;
}

/** The land in a ring of corners, m². */
export function ringArea(ring: Place[]): number {
  const origin = ring[0];
  if (!origin || ring.length < 3) return 0;
  const points = ring.map((place) => between(origin, place));
  return Math.abs(points.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = points[(i + 1) % points.length]!;
    return sum + x * nextY - nextX * y;
  }, 0)) / 2;
}
