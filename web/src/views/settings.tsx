// Language, units and currency of the page, kept by the browser.
import { setLanguage } from '../actions/session';
import { ABOUT, CURRENCIES, measures, type Currency, type System } from '../measures';
import { Button } from '../parts/button';
import { Choice, Select } from '../parts/choice';
import { NumberField } from '../parts/number_field';
import { session } from '../state/session';
import { useStore } from '../state/store';
import { language, locale, t, type Language } from '../words';

const LANGUAGES: { value: Language; label: string }[] = [{ value: 'en', label: 'English' }, { value: 'de', label: 'Deutsch' }];
const SYSTEMS: { value: System; label: string }[] = [{ value: 'metric', label: t`Metres, hectares, litres` }, { value: 'us', label: t`Feet, acres, gallons` }];
const names = new Intl.DisplayNames(locale, { type: 'currency' });

export function Settings() {
  const { system, currency, per_euro } = useStore(measures, (value) => value);
  return (
    <section class="open" aria-labelledby="settings-title">
      <h2 id="settings-title">{t`Language and units`}</h2>
      <Choice label={t`Language`} value={language} options={LANGUAGES} change={setLanguage} />
      <Choice label={t`Units`} value={system} options={SYSTEMS} change={(value) => measures.set({ system: value })} />
      <div class="two">
        <Select<Currency> label={t`Currency`} value={currency} options={CURRENCIES.map((value) => ({ value, label: `${names.of(value) ?? value} (${value})` }))}
          change={(value) => measures.set({ currency: value, per_euro: ABOUT[value] })} />
        {currency !== 'EUR' && (
          <NumberField label={t`A euro is worth`} unit={currency} value={per_euro} least={0.0001} most={100_000} change={(value) => value !== null && measures.set({ per_euro: value })} />
        )}
      </div>
      {currency !== 'EUR' && <p class="hint">{t`Files keep euros. What is usual for the work is converted by this rate.`}</p>}
      <Button onClick={() => session.set({ settings: false })}>{t`Done`}</Button>
    </section>
  );
}
