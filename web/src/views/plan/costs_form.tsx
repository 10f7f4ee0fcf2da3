import { money } from '../../format';
import { Button } from '../../parts/button';
import { Choice } from '../../parts/choice';
import { NumberField } from '../../parts/number_field';
import { Slider } from '../../parts/slider';
import { form, priceAt, USUAL } from '../../state/plan_form';
import { useStore } from '../../state/store';

export function CostsForm() {
  const by = useStore(form, (value) => value.by);
  return (
    <section aria-labelledby="objective-title">
      <h2 id="objective-title">What it costs you</h2>
      <Choice label="Set by" value={by} change={(value) => form.set({ by: value })}
        options={[{ value: 'prices', label: 'Prices' }, { value: 'sliders', label: 'Sliders' }]} />
      {by === 'prices' ? <ByPrices /> : <BySliders />}
    </section>
  );
}

function ByPrices() {
  const prices = useStore(form, (value) => value.prices);
  const set = (change: Partial<typeof prices>) => form.set({ prices: { ...form.get().prices, ...change } });
  return (
    <>
      <div class="two">
        <NumberField label="Overlap" unit="€/m²" value={prices.overlap} least={0} most={1000} change={(v) => v !== null && set({ overlap: v })} />
        <NumberField label="Uncovered" unit="€/m²" value={prices.uncovered} least={0} most={1000} change={(v) => v !== null && set({ uncovered: v })} />
        <NumberField label="Turn" unit="€" value={prices.turn} least={0} most={100000} change={(v) => v !== null && set({ turn: v })} />
        <NumberField label="Stop and back out" unit="€" value={prices.stop} least={0} most={100000} change={(v) => v !== null && set({ stop: v })} />
        <NumberField label="Each further subfield" unit="€" value={prices.subfield} least={0} most={100000} change={(v) => v !== null && set({ subfield: v })} />
      </div>
      <Button kind="quiet" onClick={() => form.set({ prices: USUAL })}>Usual prices</Button>
    </>
  );
}

function BySliders() {
  const sliders = useStore(form, (value) => value.sliders);
  const set = (change: Partial<typeof sliders>) => form.set({ sliders: { ...form.get().sliders, ...change } });
  const price = (notch: number, usual: number, per: string) => (notch === 0 ? 'does not matter' : `${money(priceAt(notch, usual))} ${per}`);
  const ends: [string, string] = ['does not matter', 'matters most'];
  return (
    <>
      <Slider label="Avoid overlap" value={sliders.overlap} least={0} most={10} step={1} ends={ends}
        says={price(sliders.overlap, USUAL.overlap, 'per m²')} change={(overlap) => set({ overlap })} />
      <Slider label="Avoid uncovered land" value={sliders.uncovered} least={0} most={10} step={1} ends={ends}
        says={price(sliders.uncovered, USUAL.uncovered, 'per m²')} change={(uncovered) => set({ uncovered })} />
      <Slider label="Avoid turns" value={sliders.turns} least={0} most={10} step={1} ends={ends}
        says={price(sliders.turns, USUAL.turn, 'per turn')} change={(turns) => set({ turns })} />
    </>
  );
}
