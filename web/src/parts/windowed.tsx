// A long list of which only the rows in sight exist.
import type { ComponentChildren, JSX } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { arrowKeys } from './search';

/** Shorter lists are drawn as they are. */
const FEW = 60;
const BEYOND = 8;

interface Props {
  id: string;
  label: string;
  count: number;
  row_px: number;
  /** A list item, which takes the place given where the list is long. */
  row: (index: number, place?: JSX.CSSProperties) => ComponentChildren;
  /** A row to bring into sight when it changes. */
  wanted?: number | null;
}

export function Windowed({ id, label, count, row_px, row, wanted = null }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const [span, setSpan] = useState<[number, number]>([0, 20]);
  const long = count > FEW;
  const look = () => {
    const element = box.current;
    if (!element || !long) return;
    const first = Math.max(0, Math.floor(element.scrollTop / row_px) - BEYOND);
    const last = Math.min(count, Math.ceil((element.scrollTop + element.clientHeight) / row_px) + BEYOND);
    if (first !== span[0] || last !== span[1]) setSpan([first, last]);
  };
  useLayoutEffect(look, [count, long]);
  useLayoutEffect(() => {
    const element = box.current;
    if (wanted === null || wanted < 0 || !element) return;
    if (long) element.scrollTop = Math.max(0, wanted * row_px - element.clientHeight / 2);
    look();
  }, [wanted]);
  if (!long) {
    return <ul class="cards" id={id} aria-label={label} onKeyDown={arrowKeys}>{Array.from({ length: count }, (_, i) => row(i))}</ul>;
  }
  const [first, last] = [Math.min(span[0], count), Math.min(span[1], count)];
  return (
    <div class="windowed" ref={box} onScroll={look} tabIndex={0} role="region" aria-label={label}>
      <ul class="rows" id={id} style={{ height: `${count * row_px}px` }} onKeyDown={arrowKeys}>
        {Array.from({ length: Math.max(0, last - first) }, (_, i) => row(first + i, { top: `${(first + i) * row_px}px`, height: `${row_px}px` }))}
      </ul>
    </div>
  );
}
