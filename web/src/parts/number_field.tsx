import { useEffect, useId, useState } from 'preact/hooks';
import { measures, unitOf } from '../measures';
import { useStore } from '../state/store';
import { language, t } from '../words';

interface Props {
  label: string;
  /** Of value, least and most: "m", "€/ha". The reader sees, and types, the one of theirs. */
  unit: string;
  value: number | null;
  least: number;
  most: number;
  /** May be left empty, which gives null. */
  optional?: boolean;
  whole?: boolean;
  hint?: string;
  /** What an empty field stands for: a word, or a value. */
  placeholder?: string | number;
  /** Arrow keys change it by so much, a tenth of it with Shift, and on from one end to the other. It is passed on when the key is let go, at Enter, and when it is left: not at each digit. */
  stride?: number;
  change: (value: number | null) => void;
}

/** Of what was converted the digits that matter. */
const DIGITS = 5;
const inUnit = (value: number, size: number) => (size === 1 ? value : Number((value / size).toPrecision(DIGITS)));
const shown = (value: number | null, size: number) => (value === null ? '' : language === 'de' ? String(inUnit(value, size)).replace('.', ',') : String(inUnit(value, size)));
/** Comma and point both part decimals. */
const read = (text: string) => (text === '' ? NaN : Number(text.replace(',', '.')));

/** A number with its unit; one that cannot be is told and not passed on. */
export function NumberField({ label, unit, value, least, most, optional = false, whole = false, hint, placeholder = '', stride, change }: Props) {
  const id = useId();
  useStore(measures, (all) => all);
  const { name, size } = unitOf(unit);
  const [text, setText] = useState(shown(value, size));
  const [fault, setFault] = useState('');
  useEffect(() => {
    if (read(text.trim()) * size === value) return;
    setText(shown(value, size));
    setFault('');
  }, [value, size]);

  const typed = (input: string, change: (value: number | null) => void) => {
    setText(input);
    const trimmed = input.trim();
    if (trimmed === '' && optional) {
      setFault('');
      change(null);
      return;
    }
    const number = read(trimmed);
    const [low, high] = [inUnit(least, size), inUnit(most, size)];
    const right = Number.isFinite(number) && number >= low && number <= high && (!whole || Number.isInteger(number));
    setFault(right ? '' : whole ? t`Type a whole number from ${low} to ${high}.` : t`Type a number from ${low} to ${high}.`);
    // Limits are rounded in units that are converted.
    if (right) change(size === 1 ? number : Math.min(most, Math.max(least, number * size)));
  };
  /** As fine as the arrow keys go: what is finer would be another number each time it is left. */
  const tidied = (number: number) => Number((Math.round(number / (stride! / 10)) * (stride! / 10)).toPrecision(DIGITS));
  const settle = () => {
    const number = read(text.trim());
    if (stride === undefined || !Number.isFinite(number)) return;
    if (tidied(number) * size === value) setText(shown(value, size));
    else typed(shown(tidied(number), 1), change);
  };
  const keyed = (event: KeyboardEvent) => {
    if (event.key === 'Enter') settle();
    const way = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
    const number = read(text.trim());
    if (stride === undefined || way === 0 || !Number.isFinite(number)) return;
    event.preventDefault();
    const [low, span] = [inUnit(least, size), inUnit(most, size) - inUnit(least, size)];
    const next = number - low + way * (event.shiftKey ? stride / 10 : stride);
    typed(shown(tidied(low + (((next % span) + span) % span)), 1), () => {});
  };
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <div class="with-unit">
        <input
          id={id}
          type="text"
          inputMode={whole ? 'numeric' : 'decimal'}
          autocomplete="off"
          value={text}
          placeholder={typeof placeholder === 'number' ? shown(Math.round(placeholder * 100) / 100, size) : placeholder}
          aria-invalid={fault !== ''}
          aria-describedby={`${id}-more`}
          onInput={(event) => typed(event.currentTarget.value, stride === undefined ? change : () => {})}
          onKeyDown={keyed} onKeyUp={(event) => event.key.startsWith('Arrow') && settle()} onBlur={settle}
        />
        {name && <span class="unit" aria-hidden="true">{name}</span>}
      </div>
      <p id={`${id}-more`} class={fault ? 'fault' : 'hint'}>
        {fault || hint}
        {name && <span class="unseen">{t` In ${name}.`}</span>}
      </p>
    </div>
  );
}
