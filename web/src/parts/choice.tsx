import { useId } from 'preact/hooks';

interface Props<V extends string> {
  label: string;
  value: V;
  options: { value: V; label: string }[];
  hint?: string;
  change: (value: V) => void;
}

/** A few things of which one is chosen, side by side. */
export function Choice<V extends string>({ label, value, options, hint, change }: Props<V>) {
  const name = useId();
  return (
    <fieldset class="field choice">
      <legend>{label}</legend>
      <div class="options">
        {options.map((option) => (
          <label key={option.value}>
            <input type="radio" name={name} checked={option.value === value} onChange={() => change(option.value)} />
            <span>{option.label}</span>
          </label>
        ))}
      </div>
      {hint && <p class="hint">{hint}</p>}
    </fieldset>
  );
}

/** One of many, in a list. */
export function Select<V extends string>({ label, value, options, hint, change }: Props<V>) {
  const id = useId();
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={(event) => change(event.currentTarget.value as V)}>
        {options.map((option) => (
          <option key={option.value} value={option.value} selected={option.value === value}>
            {option.label}
          </option>
        ))}
      </select>
      {hint && <p class="hint">{hint}</p>}
    </div>
  );
}
