import { useEffect, useId, useState } from 'preact/hooks';

interface Props {
  label: string;
  unit: string;
  value: number | null;
  least: number;
  most: number;
  /** May be left empty, which gives null. */
  optional?: boolean;
  whole?: boolean;
  hint?: string;
  /** What an empty field stands for. */
  placeholder?: string;
  change: (value: number | null) => void;
}

const shown = (value: number | null) => (value === null ? '' : String(value));

/** A number with its unit; one that cannot be is told and not passed on. Comma and point both part decimals. */
export function NumberField({ label, unit, value, least, most, optional = false, whole = false, hint, placeholder, change }: Props) {
  const id = useId();
  const [text, setText] = useState(shown(value));
  const [fault, setFault] = useState('');
  useEffect(() => {
    if (Number(text.replace(',', '.')) === value && text !== '') return;
    setText(shown(value));
    setFault('');
  }, [value]);

  const typed = (input: string) => {
    setText(input);
    const trimmed = input.trim().replace(',', '.');
    if (trimmed === '' && optional) {
      setFault('');
      change(null);
      return;
    }
    const number = Number(trimmed);
    const right = trimmed !== '' && Number.isFinite(number) && number >= least && number <= most && (!whole || Number.isInteger(number));
    setFault(right ? '' : `Type a ${whole ? 'whole ' : ''}number from ${least} to ${most}.`);
    if (right) change(number);
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
          placeholder={placeholder}
          aria-invalid={fault !== ''}
          aria-describedby={`${id}-more`}
          onInput={(event) => typed(event.currentTarget.value)}
        />
        {unit && <span class="unit" aria-hidden="true">{unit}</span>}
      </div>
      <p id={`${id}-more`} class={fault ? 'fault' : 'hint'}>
        {fault || hint}
        {unit && <span class="unseen"> In {unit}.</span>}
      </p>
    </div>
  );
}
