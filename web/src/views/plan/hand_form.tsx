// A hand on the plan: its direction, its parts, and what is left out; each step held against the plan that nobody had a hand in.
import { drawFor } from '../../actions/drawing';
import { addLand, alongLine, forgetEdits, lockPart, redoEdit, removeLand, undoEdit } from '../../actions/hand';
import { note } from '../../actions/notices';
import type { Geometry, Land, Place, PlanFull } from '../../api/types';
import { area, degrees, length, money } from '../../format';
import { bearing, directionOf, distance, ringArea, turnedTo } from '../../metres';
import { borderBeside, guideWithin, longestTrack, outerRing } from '../../map/tracks_on_map';
import { Button } from '../../parts/button';
import { NumberField } from '../../parts/number_field';
import type { Purpose } from '../../state/drawing';
import { hand, type Best } from '../../state/hand';
import { costOf, form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { sameRates } from '../../state/rates';
import { useStore } from '../../state/store';
import { t } from '../../words';

/** How much more than the best plan this one costs; null where they cannot be compared. */
function moreThan(best: Best | null, plan: PlanFull): number | null {
  if (!best || best.field !== plan.field) return null;
  const whole = plan.summary.whole_cost;
  if (whole && best.euros !== null && best.rates && sameRates(whole.rates, best.rates)) return whole.euros - best.euros;
  return whole || best.euros !== null ? null : costOf(plan.summary) - costOf(best.counts);
}

const KINDS: Record<Land['kind'], string> = { skip: t`Forbidden`, done: t`Not to be worked`, subfield: t`Subfield`, cut: t`Cut` };
const title = ({ kind, guide }: Land) => (kind === 'subfield' && guide ? t`Kept as it is` : KINDS[kind]);
const sizeOf = ({ geometry }: Land) => {
  if (geometry.type === 'LineString') {
    const line = geometry.coordinates as Place[];
    return length(line.slice(1).reduce((sum, place, i) => sum + distance(line[i]!, place), 0));
  }
  return area(ringArea(outerRing(geometry)));
};

/** Purposes of drawing, by what becomes of the shape. */
const DRAWN: { purpose: Purpose; label: string; land: (geometry: Geometry) => Land }[] = [
  { purpose: 'skip', label: t`Forbid an area`, land: (geometry) => ({ kind: 'skip', geometry }) },
  { purpose: 'exempt', label: t`Exempt an area`, land: (geometry) => ({ kind: 'done', geometry }) },
  { purpose: 'subfield', label: t`Draw a subfield`, land: (geometry) => ({ kind: 'subfield', geometry }) },
  { purpose: 'cut', label: t`Cut the field`, land: (geometry) => ({ kind: 'cut', geometry }) },
];

const tenths = (deg: number) => Math.round(deg * 10) / 10;

export function HandForm({ plan }: { plan: PlanFull }) {
  const { land, line } = useStore(form, (value) => value);
  const { past, future, best } = useStore(hand, (value) => value);
  const shapes = useStore(plans, (value) => value.shapes);
  const job = useStore(plans, (value) => value.job);
  const track = longestTrack(shapes['tracks']);
  const parts = shapes['subfields']?.features ?? [];
  const guide = line?.length === 2 ? line : track && borderBeside([track[0]!, track[track.length - 1]!], plan.summary.width_m);
  const more = past.length > 0 ? moreThan(best, plan) : null;
  const lock = (geometry: Geometry) => {
    const guide = guideWithin(geometry, shapes['tracks'], plan.summary.width_m);
    if (!guide) note(t`No track runs through this part, so that its direction is free.`);
    lockPart(geometry, guide);
  };
  return (
    <section aria-labelledby="hand-title">
      <h2 id="hand-title">{t`By hand`}</h2>
      <div class="row">
        {guide && (
          <Button onClick={() => drawFor('direction', async (geometry) => alongLine(geometry.coordinates as Place[]), { places: guide, changed: alongLine, cancelled: () => forgetEdits(past.length) })}>
            {t`Drag the direction`}
          </Button>
        )}
        {DRAWN.map(({ purpose, label, land: made }) => <Button key={purpose} onClick={() => drawFor(purpose, async (geometry) => addLand(made(geometry)))}>{label}</Button>)}
        <Button onClick={() => drawFor('lock', async (geometry) => lock(geometry))}>{t`Keep a part as it is`}</Button>
      </div>
      {guide && (
        <NumberField label={t`Direction`} unit="°" value={tenths(directionOf(guide)) % 180} least={0} most={180} stride={1}
          hint={t`Of the tracks, clockwise from north. Up and down change it by 1°, with Shift by 0.1°.`} change={(deg) => deg !== null && alongLine(turnedTo(guide, deg))} />
      )}
      {parts.length > 1 && parts.length <= 8 && (
        <div class="row">
          {parts.map(({ geometry }, i) => geometry?.type === 'Polygon' && (
            <Button key={i} kind="quiet" onClick={() => lock(geometry)}>{t`Keep subfield ${i + 1}, ${area(ringArea(outerRing(geometry)))}`}</Button>
          ))}
        </div>
      )}
      {(land.length > 0 || line) && (
        <ul class="plain">
          {line && <li>{t`Along a line towards ${degrees(bearing(line[0]!, line[line.length - 1]!))}`}</li>}
          {land.map((one, i) => (
            <li key={i} class="between">
              <span>{`${title(one)} · ${sizeOf(one)}`}</span>
              <Button kind="quiet" aria-label={t`Remove: ${title(one)}, ${sizeOf(one)}`} onClick={() => removeLand(i)}>{t`Remove`}</Button>
            </li>
          ))}
        </ul>
      )}
      {land.some(({ kind }) => kind === 'done') && <p class="hint">{t`With an exempt area tracks alone are planned: headland passes go round a whole field.`}</p>}
      {more !== null && !job && (
        <p class="verdict" role="status">
          {Math.abs(more) < 0.005 ? t`It costs as much as the best plan.` : more > 0 ? t`${money(more)} more than the best plan.` : t`${money(-more)} less than the plan before.`}
          {plan.asked?.edit_of && <span class="sub">{t`Headlands and directions that you left alone are those of the best plan. Press Plan again to search for better ones.`}</span>}
          {plan.summary.cut_short && !plan.asked?.edit_of && <span class="sub">{t`Searched for a moment only. Press Plan again for the whole search.`}</span>}
        </p>
      )}
      {past.length + future.length > 0 && (
        <div class="row">
          <Button disabled={past.length === 0} aria-label={t`Undo the last step by hand`} onClick={undoEdit}>{t`Undo`}</Button>
          <Button disabled={future.length === 0} aria-label={t`Redo the step by hand`} onClick={redoEdit}>{t`Redo`}</Button>
        </div>
      )}
    </section>
  );
}
