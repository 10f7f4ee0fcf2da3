// From the plan to the machine: which display, which file, and how to carry it there.
import { useState } from 'preact/hooks';
import { attempt, note } from '../../actions/notices';
import { keepPlan } from '../../actions/plans';
import { takeFile } from '../../actions/files/take_file';
import { planFile } from '../../api/addresses';
import type { PlanFull } from '../../api/types';
import { Button } from '../../parts/button';
import { Choice, Select } from '../../parts/choice';
import { Icon } from '../../parts/icon';
import { NumberField } from '../../parts/number_field';
import { DISPLAYS, keepDisplay, lastDisplay, needsEarth, needsRoute, type Display, type Wanted } from '../../state/displays';
import { fields } from '../../state/fields';
import { useStore } from '../../state/store';
import { t } from '../../words';
import { OnThePhone } from './on_the_phone';

export function TakeAlong({ plan }: { plan: PlanFull }) {
  const [key, setKey] = useState(lastDisplay());
  const display = DISPLAYS.find((one) => one.key === key);
  return (
    <section aria-labelledby="along-title">
      <h2 id="along-title">{t`Onto the machine`}</h2>
      <Select label={t`Which display?`} value={key} options={[{ value: '', label: t`choose one` }, ...DISPLAYS.map(({ key: value, label }) => ({ value, label }))]}
        change={(value) => {
          keepDisplay(value);
          setKey(value);
        }} />
      {display && <ForDisplay key={key} plan={plan} display={display} />}
      <OnThePhone plan={plan} />
    </section>
  );
}

/** Above a crop that is sprayed. */
const USUAL_ALTITUDE_M = 3;

function ForDisplay({ plan, display }: { plan: PlanFull; display: Display }) {
  const [lines, setLines] = useState<'subfield' | 'all'>('subfield');
  const [altitude, setAltitude] = useState<number | null>(display.flown === 'always' ? USUAL_ALTITUDE_M : null);
  const geodetic = useStore(fields, (value) => (value.open?.id === plan.field ? value.open.geodetic : true));
  const take = async (file: Wanted) => {
    const query = { ...(display.lines ? { lines } : {}), ...(display.flown && altitude !== null ? { flight_altitude_m: altitude } : {}) };
    const name = await takeFile(planFile(plan.id, file.format, query));
    note(t`${name} is in your downloads.`);
    if (plan.draft) await keepPlan(plan.id);
  };
  const why = display.files.some((file) => needsRoute(file) && !plan.summary.route) ? t`This plan is of tracks alone. Plan the whole job to get its route.`
    : display.files.some((file) => needsEarth(file) && !geodetic) ? t`This field is in plain metres: no display can find it on earth.` : null;
  return (
    <>
      {display.lines && (
        <Choice label={t`Guidance lines`} value={lines} change={setLines} options={[{ value: 'subfield', label: t`One for each subfield` }, { value: 'all', label: t`Every track` }]} />
      )}
      {display.flown && (
        <NumberField label={t`Altitude of a drone`} unit="m" value={altitude} least={0.5} most={1500} optional={display.flown === 'may be'}
          hint={display.flown === 'may be' ? t`If left empty: it stays on the ground.` : ''} change={setAltitude} />
      )}
      {why !== null ? <p class="notice error">{why}</p> : (
        <>
          <div class="row">
            {display.files.map((file) => <Button key={file.format} kind="main" onClick={() => void attempt(() => take(file))}><Icon name="down" /> {file.label}</Button>)}
          </div>
          <ol class="steps">{display.steps.map((step) => <li key={step}>{step}</li>)}</ol>
          <p class="hint">{t`Checked against the standards, and not on every display: try a small field first.`}</p>
        </>
      )}
    </>
  );
}
