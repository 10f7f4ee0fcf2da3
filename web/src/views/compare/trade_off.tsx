import { useState } from 'preact/hooks';
import { cancelFront, comparison, makeFront, openPoint } from '../../actions/compare';
import { attempt } from '../../actions/notices';
import type { FrontPoint } from '../../api/types';
import { count, money, plural, squareMetres } from '../../format';
import { Button } from '../../parts/button';
import { Expander } from '../../parts/expander';
import { Progress } from '../../parts/progress';
import { compare } from '../../state/compare';
import { form } from '../../state/plan_form';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { Chart } from './chart';
import { marksOf } from './marks';
import { t } from '../../words';

export function TradeOff({ field }: { field: string }) {
  const front = useStore(compare, (value) => (value.field === field ? value.front : null));
  const job = useStore(compare, (value) => value.job);
  useStore(form, (value) => value);
  useStore(plans, (value) => value.open);
  const { instead } = comparison(field);
  return (
    <section aria-labelledby="front-title">
      <h2 id="front-title">{t`Plans worth a choice`}</h2>
      {!front && <p class="hint">{t`Fewer turns mean more overlap or more uncovered land. This finds the plans that no other plan beats in every number, for the machine and the settings under Plan.`}</p>}
      {instead.length > 0 && !job && (
        <p class="hint" role="note">{t`A comparison is of tracks in all directions. ${instead.join(' ')}`}</p>
      )}
      {job ? (
        <Progress job={job} title={t`Comparing`} cancel={() => void attempt(cancelFront)} />
      ) : (
        <Button kind={front ? 'plain' : 'main'} onClick={() => void attempt(makeFront)}>{front ? t`Find them again` : t`Find the plans`}</Button>
      )}
      {front && <Points points={front.front} />}
    </section>
  );
}

function Points({ points }: { points: FrontPoint[] }) {
  const [hovered, setHovered] = useState<number | null>(null);
  const laying = useStore(compare, (value) => value.laying);
  const open = useStore(plans, (value) => value.open?.id);
  const laid = useStore(compare, (value) => value.laid);
  const opened = points.find((point) => laid[point.point] === open && open !== undefined);
  const about = points.find((point) => point.point === (hovered ?? opened?.point)) ?? null;
  const choose = (point: number) => void attempt(() => openPoint(point));
  return (
    <>
      <Chart points={points} open={opened?.point ?? null} hovered={hovered} hover={setHovered} choose={choose} />
      <p class="about" role="status">
        {laying !== null ? t`Making plan ${laying} …` : about ? (
          <>
            <strong>{`${t`Plan`} ${about.point}`}</strong>
            {t`: ${squareMetres(about.overlap_m2)} overlap, ${squareMetres(about.uncovered_m2)} uncovered, ${plural(about.turns, 'turn')}, ${plural(about.stops, 'stop')}, ${money(about.cost)}${about.marks.length > 0 ? ` – ${marksOf(about)}` : ''}.`}
          </>
        ) : t`${plural(points.length, 'plan')}. Point at one to see its numbers; click it to show it on the map.`}
      </p>
      <Expander title={t`The same as a table`}>
        <div class="wide-table" tabIndex={0} role="region" aria-label={t`Plans worth a choice, as a table`}>
          <table>
            <thead><tr><th>{t`Plan`}</th><th>{t`Overlap`}</th><th>{t`Uncovered`}</th><th>{t`Turns`}</th><th>{t`Stops`}</th><th>{t`Cost`}</th></tr></thead>
            <tbody>
              {points.map((point) => (
                <tr key={point.point} aria-current={point.point === opened?.point}>
                  <td><Button aria-label={t`Show plan ${point.point}`} onClick={() => choose(point.point)}>{point.point}</Button></td>
                  <td>{squareMetres(point.overlap_m2)}</td>
                  <td>{squareMetres(point.uncovered_m2)}</td>
                  <td>{count(point.turns)}</td>
                  <td>{count(point.stops)}</td>
                  <td>{money(point.cost)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </Expander>
    </>
  );
}
