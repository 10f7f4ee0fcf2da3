// The tracks of the open plan as they are drawn: their lines, and the border of a swath beside one.
import type { FeatureCollection, Geometry, Place } from '../api/types';
import { between, distance, shifted } from '../metres';

function linesOf(shapes: FeatureCollection | undefined): Place[][] {
  return (shapes?.features ?? []).flatMap(({ geometry }) =>
    geometry?.type === 'LineString' ? [geometry.coordinates as Place[]] : geometry?.type === 'MultiLineString' ? (geometry.coordinates as Place[][]) : []);
}

const lengthOf = (line: Place[]) => line.slice(1).reduce((sum, place, i) => sum + distance(line[i]!, place), 0);
const longest = (lines: Place[][]) => lines.reduce<Place[] | null>((best, line) => (best === null || lengthOf(line) > lengthOf(best) ? line : best), null);

/** The longest track. */
export const longestTrack = (shapes: FeatureCollection | undefined) => longest(linesOf(shapes));

export const outerRing = (geometry: Geometry): Place[] => (geometry.type === 'Polygon' ? (geometry.coordinates as Place[][])[0]! : []);

function inside(ring: Place[], [x, y]: Place): boolean {
  let odd = false;
  for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
    const [[xi, yi], [xj, yj]] = [ring[i]!, ring[j]!];
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) odd = !odd;
  }
  return odd;
}

/** A bend of a straight line is rounding, m. */
const STRAIGHT_M = 0.2;
function straight(line: Place[]): boolean {
  const [from, to] = [line[0]!, line[line.length - 1]!];
  const [east, north] = between(from, to);
  const long = Math.hypot(east, north);
  return long > 0 && line.every((place) => {
    const [x, y] = between(from, place);
    return Math.abs(x * north - y * east) / long < STRAIGHT_M;
  });
}

/**
 * What tracks in this part of the field follow so that they stay where they are: the border of the swath of the longest track there, or the track itself
 * where it bends. Null where no track runs through the part.
 */
export function guideWithin(geometry: Geometry, shapes: FeatureCollection | undefined, width_m: number): Place[] | null {
  const ring = outerRing(geometry);
  const there = linesOf(shapes).filter((line) => line.length > 1 && inside(ring, middleOf(line)));
  const line = longest(there);
  return line && borderBeside(line, width_m);
}

/** The border of the swath of a track, along which the same tracks lie; a track that bends is itself what others follow. */
export function borderBeside(line: Place[], width_m: number): Place[] {
  if (!straight(line)) return line;
  return shifted([line[0]!, line[line.length - 1]!], width_m / 2);
}

function middleOf(line: Place[]): Place {
  let left = lengthOf(line) / 2;
  for (let i = 1; i < line.length; i++) {
    const long = distance(line[i - 1]!, line[i]!);
    if (long >= left && long > 0) {
      const part = left / long;
      return [line[i - 1]![0] + part * (line[i]![0] - line[i - 1]![0]), line[i - 1]![1] + part * (line[i]![1] - line[i - 1]![1])];
    }
    left -= long;
  }
  return line[line.length - 1]!;
}
