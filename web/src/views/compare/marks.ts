// What stands out about a plan of the trade-off.
import type { FrontPoint } from '../../api/types';

const MARKS: Record<string, string> = {
  given_prices: 'cheapest at your prices',
  knee: 'balanced',
  least_overlap: 'least overlap',
  least_uncovered: 'least uncovered',
  fewest_turns_and_stops: 'fewest turns and stops',
};
export const marksOf = (point: FrontPoint) => point.marks.map((mark) => MARKS[mark] ?? mark).join(', ');
