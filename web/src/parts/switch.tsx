import type { ComponentChildren } from 'preact';

interface Props {
  on: boolean;
  label: ComponentChildren;
  /** Drawn before the label, as on the map. */
  mark?: { colour: string; form: 'area' | 'line' | 'dashed' | 'hatch' } | undefined;
  value?: string;
  change: (on: boolean) => void;
}
export const Switch = ({ on, label, mark, value, change }: Props) => (
  <label class="switch">
    <input type="checkbox" role="switch" checked={on} onChange={(event) => change(event.currentTarget.checked)} />
    <span class="knob" aria-hidden="true" />
    {mark && (
      <svg class="mark" viewBox="0 0 20 20" aria-hidden="true">
        {mark.form === 'area' && <rect x="2" y="3" width="16" height="14" rx="2" fill={mark.colour} stroke="currentColor" stroke-opacity="0.4" />}
        {mark.form === 'hatch' && <path d="M2 12 8 3M5 17 15 3M12 17 18 8" stroke={mark.colour} stroke-width="2" />}
        {mark.form === 'line' && <path d="M1 10H19" stroke={mark.colour} stroke-width="3" />}
        {mark.form === 'dashed' && <path d="M1 10H19" stroke={mark.colour} stroke-width="3" stroke-dasharray="5 3" />}
      </svg>
    )}
    <span class="grow">{label}</span>
    {value !== undefined && <span class="number">{value}</span>}
  </label>
);
