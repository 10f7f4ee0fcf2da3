// What stands out about a plan of the trade-off.
import type { FrontPoint } from '../../api/types';
import { t } from '../../words';

const MARKS: Record<string, string> = {
  given_prices: t`cheapest at your prices`,
  knee: t`balanced`,
  least_overlap: t`least overlap`,
  least_uncovered: t`least uncovered`,
  fewest_turns_and_stops: t`fewest turns and stops`,
};
export const marksOf = (point: FrontPoint) => point.marks.map((mark) => MARKS[mark] ?? mark).join(', ');
