// What is needed besides the log: which of its logs, which field, how wide, which plan was followed.
import { useEffect, useState } from 'preact/hooks';
import { evaluate } from '../../actions/drives';
import { attempt } from '../../actions/notices';
import { plansOf } from '../../actions/plans';
import type { DriveOptions, PlanItem, Upload } from '../../api/types';
import { clock, count, money, timeOfDay, when, width } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { NumberField } from '../../parts/number_field';
import { fields } from '../../state/fields';
import { form } from '../../state/plan_form';
import { review } from '../../state/review';
import { useStore } from '../../state/store';
import { farFrom, fieldBelow, WhereDriven } from './where_driven';
import { WorkForm } from './work_form';
import { t } from '../../words';

const NONE = '';

export function LogForm({ upload }: { upload: Upload }) {
  const logs = upload.logs ?? [];
  const list = useStore(fields, (value) => value.list) ?? [];
  const usable = logs.filter((one) => !one.refused);
  const [log, setLog] = useState((usable[0] ?? logs[0])?.name ?? NONE);
  const [plan, setPlan] = useState(NONE);
  const [plansThere, setPlansThere] = useState<PlanItem[]>([]);
  const chosen = logs.find((one) => one.name === log) ?? logs[0];
  const partfields = (upload.partfields ?? []).length;
  const bbox = chosen?.bbox ?? null;
  const open = useStore(fields, (value) => value.open) ?? undefined;
  const below = fieldBelow(bbox, list);
  // The open field where the log was driven on it, else the one it was driven on, else none.
  const likely = () => {
    if (open && farFrom(bbox, open) === null) return open.id;
    return partfields > 0 ? NONE : (below?.id ?? NONE);
  };
  const [field, setField] = useState(likely);
  const needsWidth = !chosen || chosen.width_m === null;
  const [width_m, setWidth] = useState<number | null>(null);
  const [options, setOptions] = useState<DriveOptions>({});
  useEffect(() => {
    setPlan(NONE);
    if (field === NONE) setPlansThere([]);
    else void attempt(async () => setPlansThere(await plansOf(field)));
  }, [field]);

  const go = (on = field) =>
    attempt(() =>
      evaluate(upload, {
        log: logs.length > 1 ? log : null,
        field: on || null,
        plan: (on === field && plan) || null,
        width_m: width_m ?? (needsWidth ? form.get().machine.width_m : null),
        options,
      }),
    );
  return (
    <section aria-labelledby="log-title">
      <h2 id="log-title">{upload.name}</h2>
      <WhereDriven bbox={bbox} open={open} chosen={list.find((one) => one.id === field)} below={below} go={(on) => { setField(on); void go(on); }} />
      {logs.length > 1 && (
        <Select label={t`Which of its ${logs.length} logs`} value={log} change={setLog}
          options={logs.map((one) => ({ value: one.name, label: t`${one.name}, ${count(one.fixes)} fixes` }))} />
      )}
      {chosen && (
        <p class="hint">
          {t`${count(chosen.fixes)} fixes`}
          {chosen.from_s !== null && chosen.to_s !== null && t` in ${clock(chosen.to_s - chosen.from_s)} h`}
          {timeOfDay(chosen.from_s) && t`, from ${timeOfDay(chosen.from_s)}`}
          {chosen.width_m !== null ? t`, ${width(chosen.width_m)} wide.` : t`. The log does not say how wide the machine works.`}
        </p>
      )}
      <Select label={t`Field`} value={field} change={setField}
        hint={field === NONE ? (partfields > 0 ? t`The field in the task set is used.` : t`Without a field nothing can be missed: only what was worked is shown.`) : ''}
        options={[{ value: NONE, label: partfields > 0 ? t`the one in the file` : t`none` }, ...list.map((one) => ({ value: one.id, label: one.name }))]} />
      {plansThere.length > 0 && (
        <Select label={t`Plan that was followed`} value={plan} change={setPlan}
          options={[
            { value: NONE, label: t`none` },
            ...plansThere.map((one) => ({ value: one.id, label: `${one.name || t`Plan`} · ${when(one.created)} · ${width(one.width_m)} · ${money(one.cost)}` })),
          ]} />
      )}
      <NumberField label={t`Working width`} unit="m" value={width_m ?? (needsWidth ? form.get().machine.width_m : null)} least={0.2} most={100} optional={!needsWidth}
        hint={needsWidth ? '' : t`If left empty: as the log says.`} change={setWidth} />
      <WorkForm options={options} change={setOptions} />
      <div class="row">
        <Button kind="main" onClick={() => void go()}>{t`Show what was worked`}</Button>
        <Button onClick={() => review.set({ upload: null })}>{t`Back`}</Button>
      </div>
    </section>
  );
}
