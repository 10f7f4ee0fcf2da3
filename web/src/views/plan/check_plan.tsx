// The verifier's verdict: the plan worked out anew from its tracks alone.
import { attempt } from '../../actions/notices';
import { cancelCheck, checkPlan } from '../../actions/planning';
import type { Check, Checked, CheckedPlace, Place, PlanFull } from '../../api/types';
import { count, area, length, sentence, squareMetres } from '../../format';
import { engine } from '../../map/engine_loader';
import { Button } from '../../parts/button';
import { Progress } from '../../parts/progress';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { t } from '../../words';

const ROWS: { label: string; of: (figures: Checked) => number; write: (value: number) => string }[] = [
  { label: t`Overlap`, of: (f) => f.overlap_m2, write: squareMetres },
  { label: t`Uncovered`, of: (f) => f.uncovered_m2, write: squareMetres },
  { label: t`Worked`, of: (f) => f.worked_m2, write: area },
  { label: t`Tracks`, of: (f) => f.tracks, write: count },
  { label: t`Length of tracks`, of: (f) => f.track_length_m, write: length },
  { label: t`Turns`, of: (f) => f.turns, write: count },
  { label: t`Stops`, of: (f) => f.stops, write: count },
];
const NEAR_M = 20;

export function CheckPlan({ plan }: { plan: PlanFull }) {
  const job = useStore(plans, (value) => value.checking);
  const checked = useStore(plans, (value) => (value.checked?.plan === plan.id ? value.checked.check : null));
  return (
    <section aria-labelledby="check-title">
      <h2 id="check-title">{t`Check`}</h2>
      {checked ? <Verdict check={checked} /> : (
        <p class="hint">{t`An independent check looks at every track again: does it stay inside the field and clear of obstacles, can it be driven, and are the figures right?`}</p>
      )}
      {job ? <Progress job={job} title={t`Checking`} cancel={() => void attempt(cancelCheck)} /> : (
        <Button onClick={() => void attempt(() => checkPlan(plan.id))}>{checked ? t`Check it again` : t`Check this plan`}</Button>
      )}
    </section>
  );
}

const show = (at: Place) => engine()?.look(at, NEAR_M);

function Places({ places }: { places: CheckedPlace[] }) {
  if (places.length === 0) return null;
  return (
    <ul class="plain">
      {places.map(({ rule, what, at }, i) => (
        <li key={i} class="between">
          <span>{sentence(what)} <span class="sub">{t`Rule: ${rule}`}</span></span>
          <Button kind="quiet" aria-label={t`Show place ${i + 1} on the map`} onClick={() => show(at)}>{t`Show`}</Button>
        </li>
      ))}
    </ul>
  );
}

function Verdict({ check: { ok, violations, findings, recomputed, stored } }: { check: Check }) {
  const many = violations.length;
  return (
    <>
      <p role="status" class={ok ? 'verdict' : 'verdict fault'}>
        {ok
          ? findings.length === 0 ? t`The plan holds: every track lies where it may and can be driven, and the figures are right.` : t`The plan holds: every track lies where it may, and the figures are right.`
          : many === 1 ? t`The plan does not hold in one place. Make it again; if it still does not hold, do not drive it.` : t`The plan does not hold in ${count(many)} places. Make it again; if it still does not hold, do not drive it.`}
      </p>
      <Places places={violations} />
      {findings.length > 0 && (
        <details>
          <summary>{findings.length === 1 ? t`One place a machine cannot drive as drawn` : t`${count(findings.length)} places a machine cannot drive as drawn`}</summary>
          <p class="hint">{t`The plan was made by the rules of a paper, which do not promise that every track can be driven.`}</p>
          <Places places={findings} />
        </details>
      )}
      {recomputed && (
        <table class="differences">
          <thead><tr><td /><th>{t`Plan`}</th><th>{t`Check`}</th></tr></thead>
          <tbody>
            {ROWS.map(({ label, of, write }) => (
              <tr key={label}><th scope="row">{label}</th><td>{write(of(stored))}</td><td>{write(of(recomputed))}</td></tr>
            ))}
          </tbody>
        </table>
      )}
    </>
  );
}
