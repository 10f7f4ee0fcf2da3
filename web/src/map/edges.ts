// The edges of a field as people see them: from corner to corner, bends between.
import type { FieldFull, Place } from '../api/types';
import { fields } from '../state/fields';
import { bearing, between, distance } from '../metres';

export interface Edge {
  number: number;
  line: Place[];
  length_m: number;
  bearing_deg: number;
}

const CORNER_DEG = 25;
const SHORTEST_M = 5;

const turn = (a: number, b: number) => Math.abs(((b - a + 540) % 360) - 180);

function edgesOfRing(closedRing: Place[]): Place[][] {
  const ring = closedRing.slice(0, -1).filter((place, i, all) => distance(place, all[(i + 1) % all.length]!) > 0.05);
  const n = ring.length;
  if (n < 3) return [];
  const at = (i: number) => ring[((i % n) + n) % n]!;
  const corners = ring
    .map((_, i) => i)
    .filter((i) => turn(bearing(at(i - 1), at(i)), bearing(at(i), at(i + 1))) > CORNER_DEG);
  if (corners.length < 2) return [[...ring, ring[0]!]];
  return corners.map((from, k) => {
    const to = corners[(k + 1) % corners.length]!;
    const steps = (to - from + n) % n || n;
    return Array.from({ length: steps + 1 }, (_, i) => at(from + i));
  });
}

const lengthOf = (line: Place[]) => line.slice(1).reduce((sum, place, i) => sum + distance(line[i]!, place), 0);

/** Edges of the outer boundary, the longest first. */
function edgesOf(field: FieldFull): Edge[] {
  const rings: Place[][] = [];
  for (const { geometry, properties } of field.shapes.features) {
    if (properties['kind'] !== 'field' || !geometry) continue;
    if (geometry.type === 'Polygon') rings.push((geometry.coordinates as Place[][])[0]!);
    if (geometry.type === 'MultiPolygon') for (const part of geometry.coordinates as Place[][][]) rings.push(part[0]!);
  }
  return rings
    .flatMap(edgesOfRing)
    .map((line) => ({ line, length_m: lengthOf(line), bearing_deg: bearing(line[0]!, line[line.length - 1]!) }))
    .filter((edge) => edge.length_m >= SHORTEST_M)
    .sort((a, b) => b.length_m - a.length_m)
    .map((edge, i) => ({ ...edge, number: i + 1 }));
}

let ofField: FieldFull | null = null;
let edges: Edge[] = [];
/** Edges of the open field; worked out once for each field. */
export function openEdges(): Edge[] {
  const field = fields.get().open;
  if (field !== ofField) {
    ofField = field;
    edges = field ? edgesOf(field) : [];
  }
  return edges;
}

function distanceToSegment(p: Place, a: Place, b: Place): number {
  const [px, py] = between(a, p);
  const [bx, by] = between(a, b);
  const t = Math.max(0, Math.min(1, (px * bx + py * by) / (bx * bx + by * by || 1)));
  return Math.hypot(px - t * bx, py - t * by);
}

export function nearestEdge(edges: Edge[], place: Place): { edge: Edge; away_m: number } | null {
  let best: { edge: Edge; away_m: number } | null = null;
  for (const edge of edges) {
    for (let i = 1; i < edge.line.length; i++) {
      const away_m = distanceToSegment(place, edge.line[i - 1]!, edge.line[i]!);
      if (!best || away_m < best.away_m) best = { edge, away_m };
    }
  }
  return best;
}
