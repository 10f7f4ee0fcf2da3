import type { JSX } from 'preact';
import { useState } from 'preact/hooks';
import { goToStop, openExampleFarm } from '../../actions/example';
import { planFields, stopPlanning } from '../../actions/farm';
import { deleteField, openField } from '../../actions/fields';
import { attempt } from '../../actions/notices';
import type { FieldItem } from '../../api/types';
import { count, hectares, hours, money, plural, width } from '../../format';
import { Button } from '../../parts/button';
import { ConfirmButton } from '../../parts/confirm_button';
import { Icon } from '../../parts/icon';
import { LONG, matching, Search } from '../../parts/search';
import { Windowed } from '../../parts/windowed';
import { farm } from '../../state/farm';
import { fields } from '../../state/fields';
import { useStore } from '../../state/store';
import { t } from '../../words';

export function FieldList() {
  const list = useStore(fields, (value) => value.list);
  const open = useStore(fields, (value) => value.open?.id);
  const [typed, setTyped] = useState('');
  if (list === null) return null;
  const long = list.length > LONG;
  const found = long ? matching(list, typed, wordsOf) : list;
  return (
    <section aria-labelledby="fields-title">
      <h2 id="fields-title">{t`Your fields`}</h2>
      {list.length === 0 && (
        <>
          <p class="hint">{t`None yet. Choose a file above, or draw a field on the map. To look round first:`}</p>
          <div class="row">
            <Button onClick={() => void attempt(openExampleFarm)}>{t`Open the example farm`}</Button>
            <Button onClick={() => goToStop(0)}>{t`Take the short tour`}</Button>
          </div>
        </>
      )}
      {long && <Search label={t`Search by name, crop, tag or area`} typed={typed} found={found.length} all={list.length} list="stored-fields" change={setTyped} />}
      {list.length > 1 && <Several list={found} all={list} />}
      <Windowed id="stored-fields" label={t`Stored fields`} count={found.length} row_px={ROW_PX} row={(i, place) => <Row key={found[i]!.id} field={found[i]!} several={list.length > 1} open={found[i]!.id === open} place={place} />} />
    </section>
  );
}

const ROW_PX = 84;
const wordsOf = (field: FieldItem) => [field.name, field.crop, ...field.tags, hectares(field.area_m2)].join(' ');

/** What is known of the last plan: hours and euros where it is of the whole job. */
const planned = ({ last_plan: plan }: FieldItem) =>
  !plan ? t`not planned` : plan.hours === null ? t`tracks planned, ${width(plan.width_m)} wide` : t`${hours(plan.hours)}, ${money(plan.euros)}, ${width(plan.width_m)} wide`;

function tick(ids: string[], on: boolean): void {
  const next = new Set(farm.get().ticked);
  for (const id of ids) on ? next.add(id) : next.delete(id);
  farm.set({ ticked: next });
}

function Row({ field, several, open, place }: { field: FieldItem; several: boolean; open: boolean; place: JSX.CSSProperties | undefined }) {
  const ticked = useStore(farm, (value) => value.ticked.has(field.id));
  return (
    <li class="row tight" style={place}>
      {several && (
        <label class="tick">
          <input type="checkbox" aria-label={t`Tick ${field.name}`} checked={ticked} onChange={(event) => tick([field.id], event.currentTarget.checked)} />
        </label>
      )}
      <button type="button" class="card grow" aria-current={open} onClick={() => void attempt(() => openField(field.id))}>
        <span class="grow">
          <strong>{field.name}</strong>
          <span class="sub">{[hectares(field.area_m2), field.crop, field.obstacles > 0 && plural(field.obstacles, 'obstacle'), ...field.tags.map((tag) => `#${tag}`)].filter(Boolean).join(' · ')}</span>
          <span class="sub">{planned(field)}</span>
        </span>
      </button>
      <ConfirmButton label={t`Delete ${field.name}`} ask={t`Delete it`} act={() => void attempt(() => deleteField(field.id))}><Icon name="bin" /></ConfirmButton>
    </li>
  );
}

/** Ticked fields are planned with the machine and the settings under Plan; below, the sums of the farm. */
function Several({ list, all }: { list: FieldItem[]; all: FieldItem[] }) {
  const ticked = useStore(farm, (value) => value.ticked);
  const planning = useStore(farm, (value) => value.planning);
  const chosen = all.filter(({ id }) => ticked.has(id));
  const whole = all.filter(({ last_plan: plan }) => plan != null && plan.hours !== null);
  const sum = (value: (field: FieldItem) => number) => whole.reduce((total, field) => total + value(field), 0);
  return (
    <>
      <p class="hint">
        {t`${hectares(all.reduce((total, { area_m2 }) => total + area_m2, 0))} in all`}
        {whole.length > 0 && t`; ${plural(whole.length, 'field')} planned as a whole: ${hours(sum(({ last_plan }) => last_plan!.hours!))}, ${money(sum(({ last_plan }) => last_plan!.euros!))}`}.
      </p>
      <label class="tick">
        <input type="checkbox" checked={list.length > 0 && list.every(({ id }) => ticked.has(id))} onChange={(event) => tick(list.map(({ id }) => id), event.currentTarget.checked)} />
        <span>{list.length === all.length ? t`All ${count(list.length)} fields` : t`All ${count(list.length)} that were found`}</span>
      </label>
      {planning ? (
        <div class="progress" role="status">
          <div class="between"><span>{t`Planning the fields`}</span><span class="number">{t`${planning.done + planning.failed.length} of ${planning.of}`}</span></div>
          <progress aria-label={t`Planning the fields`} value={planning.done + planning.failed.length} max={planning.of} />
          <Button onClick={() => void attempt(stopPlanning)}>{t`Stop`}</Button>
        </div>
      ) : chosen.length > 0 && <Button kind="main" onClick={() => void attempt(() => planFields(chosen))}>{t`Plan ${plural(chosen.length, 'field')}`}</Button>}
    </>
  );
}
