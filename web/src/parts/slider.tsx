import { useId, useLayoutEffect, useRef } from 'preact/hooks';

interface Props {
  label: string;
  value: number;
  least: number;
  most: number;
  step: number | 'any';
  /** The value in words, shown at the right and read out. */
  says: string;
  ends?: [string, string];
  /** How far an arrow key goes, a tenth of it with Shift, and on from one end to the other; left out: a step. */
  stride?: number;
  /** It has the focus as soon as it is there. */
  focused?: boolean;
  change: (value: number) => void;
  /** The pointer or the key is let go. */
  settled?: () => void;
}

const ARROWS: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

export function Slider({ label, value, least, most, step, says, ends, stride, focused = false, change, settled = () => {} }: Props) {
  const id = useId();
  const input = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => {
    if (focused) input.current?.focus({ preventScroll: true });
  }, []);
  const keyed = (event: KeyboardEvent) => {
    const way = ARROWS[event.key];
    if (stride === undefined || way === undefined) return;
    event.preventDefault();
    const [span, next] = [most - least, value + way * (event.shiftKey ? stride / 10 : stride)];
    change(least + ((((next - least) % span) + span) % span));
  };
  return (
    <div class="field slider">
      <div class="between">
        <label for={id}>{label}</label>
        <output for={id}>{says}</output>
      </div>
      <input
        ref={input} id={id} type="range" min={least} max={most} step={step} value={value} aria-valuetext={says}
        onInput={(event) => change(Number(event.currentTarget.value))} onChange={() => settled()} onKeyDown={keyed} onKeyUp={() => settled()} onBlur={() => settled()}
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
