import type { ComponentChildren } from 'preact';
import { MarkOf, type Mark } from './mark';

interface Props {
  on: boolean;
  label: ComponentChildren;
  /** Drawn before the label, as on the map. */
  mark?: Mark | undefined;
  value?: string;
  change: (on: boolean) => void;
}
export const Switch = ({ on, label, mark, value, change }: Props) => (
  <label class="switch">
    <input type="checkbox" role="switch" checked={on} onChange={(event) => change(event.currentTarget.checked)} />
    <span class="knob" aria-hidden="true" />
    {mark && <MarkOf mark={mark} />}
    <span class="grow">{label}</span>
    {value !== undefined && <span class="number">{value}</span>}
  </label>
);
