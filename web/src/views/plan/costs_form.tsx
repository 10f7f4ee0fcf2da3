// What the plan is to be cheapest in: the whole job, or tracks by themselves.
import { money, moneyPerArea } from '../../format';
import { Button } from '../../parts/button';
import { Choice, Select } from '../../parts/choice';
import { NumberField } from '../../parts/number_field';
import { Slider } from '../../parts/slider';
import { form, planBy, priceAt, USUAL, type By } from '../../state/plan_form';
import { GENERAL, OPERATIONS, RATES, usual, usualOf, type RateField } from '../../state/rates';
import { useStore } from '../../state/store';
import { t } from '../../words';

const WAYS: { value: By; label: string; hint: string }[] = [
  { value: 'whole', label: t`Whole job`, hint: t`Hours, fuel, overlap, missed land and turns of the whole drive.` },
  { value: 'prices', label: t`Tracks, by prices`, hint: t`Tracks alone, without the way between them, at a price for each thing.` },
  { value: 'sliders', label: t`Tracks, by sliders`, hint: t`Tracks alone, without the way between them, by what matters to you.` },
];

export function CostsForm() {
  const by = useStore(form, (value) => value.by);
  return (
    <section aria-labelledby="objective-title">
      <h2 id="objective-title">{t`What has to cost least`}</h2>
      <Choice label={t`Compare plans by`} value={by} change={planBy} options={WAYS} hint={WAYS.find(({ value }) => value === by)?.hint ?? ''} />
      {by === 'whole' ? <ByRates /> : by === 'prices' ? <ByPrices /> : <BySliders />}
    </section>
  );
}

/** The rates of the machine; what is left empty is as usual for the operation. */
function ByRates() {
  const machine = useStore(form, (value) => value.machine);
  const operations = useStore(usual, (value) => value.operations);
  const rates = machine.rates ?? {};
  const known = usualOf(rates, operations);
  // Of the form as it is now: two fields may change before either is drawn anew.
  const set = (change: Partial<typeof rates>) => {
    const now = form.get().machine;
    const next = { ...now.rates, ...change };
    for (const key of Object.keys(next) as (keyof typeof next)[]) if (next[key] === undefined) delete next[key];
    form.set({ machine: { ...now, rates: next } });
  };
  const clear = () => {
    const { rates: _, ...rest } = machine;
    form.set({ machine: { ...rest, ...(rates.operation ? { rates: { operation: rates.operation } } : {}) } });
  };
  return (
    <>
      <Select label={t`Work`} value={rates.operation ?? GENERAL} change={(operation) => set({ operation })}
        options={Object.entries(OPERATIONS).map(([value, label]) => ({ value, label }))} />
      <div class="two">
        {RATES.map((rate) => (
          <Rate key={rate.key} rate={rate} value={rates[rate.key]} usual={known?.rates[rate.key]} set={(value) => set({ [rate.key]: value })} />
        ))}
      </div>
      <p class="hint">
        {t`What is left empty is as usual for the work: the grey numbers.`} {known && (known.standing_crop ? t`A standing crop: driving over it costs what missed land costs.` : t`No standing crop: it may be driven over.`)}
      </p>
      {RATES.some(({ key }) => rates[key] !== undefined) && <Button kind="quiet" onClick={clear}>{t`Usual rates`}</Button>}
    </>
  );
}

const Rate = ({ rate, value, usual: known, set }: { rate: RateField; value: number | undefined; usual: number | undefined; set: (value: number | undefined) => void }) => (
  <NumberField label={rate.label} unit={rate.unit} value={value ?? null} least={rate.key === 'sections' ? 1 : 0} most={rate.most} optional whole={rate.whole ?? false}
    placeholder={known ?? ''} change={(v) => set(v ?? undefined)} />
);

function ByPrices() {
  const prices = useStore(form, (value) => value.prices);
  const set = (change: Partial<typeof prices>) => form.set({ prices: { ...form.get().prices, ...change } });
  return (
    <>
      <div class="two">
        <NumberField label={t`Overlap`} unit="€/m²" value={prices.overlap} least={0} most={1000} change={(v) => v !== null && set({ overlap: v })} />
        <NumberField label={t`Uncovered`} unit="€/m²" value={prices.uncovered} least={0} most={1000} change={(v) => v !== null && set({ uncovered: v })} />
        <NumberField label={t`Turn`} unit="€" value={prices.turn} least={0} most={100000} change={(v) => v !== null && set({ turn: v })} />
        <NumberField label={t`Stop and back out`} unit="€" value={prices.stop} least={0} most={100000} change={(v) => v !== null && set({ stop: v })} />
        <NumberField label={t`Each further subfield`} unit="€" value={prices.subfield} least={0} most={100000} change={(v) => v !== null && set({ subfield: v })} />
      </div>
      <Button kind="quiet" onClick={() => form.set({ prices: USUAL })}>{t`Usual prices`}</Button>
    </>
  );
}

function BySliders() {
  const sliders = useStore(form, (value) => value.sliders);
  const set = (change: Partial<typeof sliders>) => form.set({ sliders: { ...form.get().sliders, ...change } });
  const price = (notch: number, usualPrice: number, write: (price: number) => string) => (notch === 0 ? t`does not matter` : write(priceAt(notch, usualPrice)));
  const ends: [string, string] = [t`does not matter`, t`matters most`];
  return (
    <>
      <Slider label={t`Avoid overlap`} value={sliders.overlap} least={0} most={10} step={1} ends={ends}
        says={price(sliders.overlap, USUAL.overlap, moneyPerArea)} change={(overlap) => set({ overlap })} />
      <Slider label={t`Avoid uncovered land`} value={sliders.uncovered} least={0} most={10} step={1} ends={ends}
        says={price(sliders.uncovered, USUAL.uncovered, moneyPerArea)} change={(uncovered) => set({ uncovered })} />
      <Slider label={t`Avoid turns`} value={sliders.turns} least={0} most={10} step={1} ends={ends}
        says={price(sliders.turns, USUAL.turn, (each) => t`${money(each)} per turn`)} change={(turns) => set({ turns })} />
    </>
  );
}
