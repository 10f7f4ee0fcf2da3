// What the independent reader finds in a task set, as plain values.
import { readFileSync } from 'node:fs';
import { ISOXMLManager } from 'isoxml';

const position = (point) => [point.attributes.PointEast, point.attributes.PointNorth];
const line = (string) => (string.attributes.Point ?? []).map(position);
const rings = (polygon) => polygon.attributes.LineString.map(line);

const ofType = (partfield, type) =>
  (partfield.attributes.PolygonnonTreatmentZoneonly ?? []).filter((polygon) => polygon.attributes.PolygonType === type);

/** The guidance lines of a partfield: in version 4 of its patterns, in version 3 line strings of its own. */
function guidanceOf(partfield) {
  const patterns = (partfield.attributes.GuidanceGroup ?? []).flatMap((group) => group.attributes.GuidancePattern);
  const strings = [...patterns.flatMap((pattern) => pattern.attributes.LineString), ...(partfield.attributes.LineString ?? [])];
  return strings.map((string) => ({ name: string.attributes.LineStringDesignator, points: line(string) }));
}

/** The task set in a zip: its warnings and its fields, each with boundary (rings), obstacles, headlands and lines. */
export async function readTaskSet(file) {
  const manager = new ISOXMLManager();
  await manager.parseISOXMLFile(new Uint8Array(readFileSync(file)), 'application/zip');
  const fields = manager.getEntitiesOfTag('PFD').map((partfield) => ({
    name: partfield.attributes.PartfieldDesignator,
    boundaries: ofType(partfield, '1').map(rings),
    obstacles: [...ofType(partfield, '6'), ...ofType(partfield, '8')].map(rings),
    headlands: ofType(partfield, '10').map(rings),
    lines: guidanceOf(partfield),
  }));
  return {
    warnings: manager.getWarnings(),
    fields,
    tasks: manager.getEntitiesOfTag('TSK').map((task) => task.attributes.PartfieldIdRef.entity.attributes.PartfieldDesignator),
  };
}

/** Nine decimals, and half a digit of the other file's ten. */
const DIGIT = 1e-9;

/** Why two lines are not the same, point by point; empty where they are. */
export function difference(read, wanted) {
  if (read.length !== wanted.length) return `${read.length} points instead of ${wanted.length}`;
  for (let i = 0; i < read.length; i++)
    for (const k of [0, 1])
      if (!(Math.abs(read[i][k] - wanted[i][k]) <= DIGIT)) return `point ${i + 1} is ${read[i]} instead of ${wanted[i]}`;
  return '';
}

/** The same for rings, which may begin at any of their points and run either way. */
export function ringDifference(read, wanted) {
  const one = read.slice(0, -1), other = wanted.slice(0, -1);
  for (const turned of [other, [...other].reverse()])
    for (let first = 0; first < turned.length; first++)
      if (difference(one, [...turned.slice(first), ...turned.slice(0, first)]) === '') return '';
  return `a ring of ${one.length} points is not that of ${other.length}`;
}
