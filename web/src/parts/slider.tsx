import { useId } from 'preact/hooks';

interface Props {
  label: string;
  value: number;
  least: number;
  most: number;
  step: number | 'any';
  /** The value in words, shown at the right and read out. */
  says: string;
  ends?: [string, string];
  change: (value: number) => void;
}
export function Slider({ label, value, least, most, step, says, ends, change }: Props) {
  const id = useId();
  return (
    <div class="field slider">
      <div class="between">
        <label for={id}>{label}</label>
        <output for={id}>{says}</output>
      </div>
      <input
        id={id} type="range" min={least} max={most} step={step} value={value} aria-valuetext={says}
        onInput={(event) => change(Number(event.currentTarget.value))}
      />
      {ends && (
        <div class="between ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </div>
      )}
    </div>
  );
}
