import { useState } from 'preact/hooks';

/** The name of what is open, to type over; saved when it is left. */
export function TitleField({ label, value, save }: { label: string; value: string; save: (name: string) => void }) {
  const [name, setName] = useState(value);
  const leave = () => {
    const typed = name.trim();
    if (typed === '') setName(value);
    else if (typed !== value) save(typed);
  };
  return (
    <label class="field title-field grow">
      <span class="unseen">{label}</span>
      <input type="text" value={name} maxLength={80} onInput={(event) => setName(event.currentTarget.value)} onBlur={leave}
        onKeyDown={(event) => event.key === 'Enter' && event.currentTarget.blur()} />
    </label>
  );
}
