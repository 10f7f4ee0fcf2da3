import { useState } from 'preact/hooks';

/** The name of what is open, to type over, saved when it is left; or with its label in sight another text, which may be empty. */
export function TitleField({ label, value, save, seen = false }: { label: string; value: string; save: (name: string) => void; seen?: boolean }) {
  const [name, setName] = useState(value);
  const leave = () => {
    const typed = name.trim();
    if (typed === '' && !seen) setName(value);
    else if (typed !== value) save(typed);
  };
  return (
    <label class={seen ? 'field grow' : 'field title-field grow'}>
      <span class={seen ? 'label' : 'unseen'}>{label}</span>
      <input type="text" value={name} maxLength={80} onInput={(event) => setName(event.currentTarget.value)} onBlur={leave}
        onKeyDown={(event) => event.key === 'Enter' && event.currentTarget.blur()} />
    </label>
  );
}
