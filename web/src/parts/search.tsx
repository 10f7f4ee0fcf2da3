// Finding something in a long list by any words of it.
import { useId } from 'preact/hooks';
import { plural } from '../format';
import { t } from '../words';

/** Lists up to so long can be taken in at a glance. */
export const LONG = 8;

export const folded = (text: string) => text.toLowerCase().normalize('NFD').replace(/\p{M}/gu, '');

/** The words that were typed. */
export const typedWords = (typed: string) => folded(typed).split(/\s+/).filter((word) => word !== '');

/** Those of a list whose text has every word that was typed; case and accents do not matter. */
export function matching<T>(list: readonly T[], typed: string, textOf: (item: T) => string): T[] {
  const words = typedWords(typed);
  if (words.length === 0) return [...list];
  return list.filter((item) => {
    const text = folded(textOf(item));
    return words.every((word) => text.includes(word));
  });
}

interface Props {
  label: string;
  typed: string;
  found: number;
  all: number;
  /** id of the list below, whose first entry the down arrow goes to. */
  list: string;
  change: (typed: string) => void;
}

export function Search({ label, typed, found, all, list, change }: Props) {
  const id = useId();
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && typed !== '') change('');
    else if (event.key === 'ArrowDown') document.getElementById(list)?.querySelector<HTMLElement>('.card:not(:disabled)')?.focus();
    else return;
    event.preventDefault();
  };
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <input id={id} type="search" autocomplete="off" spellcheck={false} value={typed} onInput={(event) => change(event.currentTarget.value)} onKeyDown={keys} />
      <p class="hint" role="status">
        {typed.trim() === '' ? `${plural(all, 'field')}.` : found === 0 ? t`None of ${plural(all, 'field')} has these words. Type fewer letters.` : t`Found: ${found} of ${plural(all, 'field')}.`}
      </p>
    </div>
  );
}

/** Up and down go through the cards of a list, as in a list of choices. */
export function arrowKeys(event: KeyboardEvent): void {
  const step = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
  if (step === 0 || !(event.currentTarget instanceof HTMLElement)) return;
  const cards = [...event.currentTarget.querySelectorAll<HTMLElement>('.card:not(:disabled)')];
  const at = cards.findIndex((card) => card === document.activeElement);
  if (at < 0) return;
  event.preventDefault();
  cards[at + step]?.focus();
}
