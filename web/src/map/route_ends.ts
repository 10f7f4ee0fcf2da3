// Where a route starts and where it ends.
import type { Feature, FeatureCollection, Place } from '../api/types';
import { collection } from './live_map';

const at = (place: Place, end: 'start' | 'end'): Feature => ({
  type: 'Feature', properties: { end }, geometry: { type: 'Point', coordinates: place },
});

/** The first place of the first leg and the last of the last; legs without length have no shape to go by. */
export function endsOf(legs: FeatureCollection): FeatureCollection {
  const lines = legs.features.map((leg) => (leg.geometry?.type === 'LineString' ? (leg.geometry.coordinates as Place[]) : [])).filter((line) => line.length > 0);
  const [first, last] = [lines[0], lines[lines.length - 1]];
  // The end first: where both are at one place, the start is the one to see.
  return first && last ? collection([at(last[last.length - 1]!, 'end'), at(first[0]!, 'start')]) : collection([]);
}
