// How far a machine is from the line that it follows.
import type { FeatureCollection, Place } from '../api/types';
import { between } from '../metres';

export interface OffLine {
  /** To the right of the line as the machine drives it; to the left below 0. */
  right_m: number;
  /** Number of the track in driving order; null on a headland pass. */
  order: number | null;
}

/** Lines more than this across the way driven are crossed, not followed. */
const ACROSS_DEG = 35;
const rad = (deg: number) => (deg * Math.PI) / 180;

function linesOf(shapes: FeatureCollection | undefined): { line: Place[]; order: number | null }[] {
  return (shapes?.features ?? []).flatMap(({ geometry, properties }) => {
    const order = typeof properties['order'] === 'number' ? properties['order'] : null;
    if (geometry?.type === 'LineString') return [{ line: geometry.coordinates as Place[], order }];
    if (geometry?.type === 'MultiLineString') return (geometry.coordinates as Place[][]).map((line) => ({ line, order }));
    return [];
  });
}

/** The nearest line that runs about as the machine drives; null where there is none within `reach_m`. */
export function offLine(shapes: (FeatureCollection | undefined)[], at: Place, heading_deg: number, reach_m: number): OffLine | null {
  const [aheadX, aheadY] = [Math.sin(rad(heading_deg)), Math.cos(rad(heading_deg))];
  let best: OffLine | null = null;
  for (const { line, order } of shapes.flatMap(linesOf)) {
    for (let i = 1; i < line.length; i++) {
      const [ax, ay] = between(at, line[i - 1]!);
      const [bx, by] = between(at, line[i]!);
      const [dx, dy] = [bx - ax, by - ay];
      const length = Math.hypot(dx, dy);
      if (length === 0 || Math.abs(dx * aheadX + dy * aheadY) < length * Math.cos(rad(ACROSS_DEG))) continue;
      const t = Math.max(0, Math.min(1, -(ax * dx + ay * dy) / (length * length)));
      const [x, y] = [ax + t * dx, ay + t * dy];
      const away = Math.hypot(x, y);
      if (away > reach_m || (best && away >= Math.abs(best.right_m))) continue;
      // The line lies at (x, y) of the machine: to its left where the machine is right of the line.
      const left = aheadX * y - aheadY * x > 0;
      best = { right_m: left ? away : -away, order };
    }
  }
  return best;
}
