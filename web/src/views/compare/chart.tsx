// Overlap to the right, uncovered land upwards, turns as colour: each dot is a plan.
import { useId } from 'preact/hooks';
import type { FrontPoint } from '../../api/types';
import { count, money, plural, squareMetres, typed } from '../../format';
import { unitOf } from '../../measures';
import { axis } from './axis';
import { marksOf } from './marks';
import { t } from '../../words';

const W = 380;
const H = 300;
const LEFT = 58;
const BOTTOM = 46;
const TOP = 14;
const RIGHT = 14;

interface Props {
  points: FrontPoint[];
  open: number | null;
  hovered: number | null;
  hover: (point: number | null) => void;
  choose: (point: number) => void;
}

const REACH_PX = 32;
const tickText = (size: number) => (size === 0 || size >= 1 ? count(size) : typed(size));

export function Chart({ points, open, hovered, hover, choose }: Props) {
  const name = useId();
  const { name: unit, size } = unitOf('m²');
  const across = axis(points.map((point) => point.overlap_m2 / size));
  const up = axis(points.map((point) => point.uncovered_m2 / size));
  const turns = points.map((point) => point.turns + point.stops);
  const [fewest, most] = [Math.min(...turns), Math.max(...turns)];
  const x = (value: number) => LEFT + across.at(value) * (W - LEFT - RIGHT);
  const y = (value: number) => H - BOTTOM - up.at(value) * (H - BOTTOM - TOP);
  const radius = (point: FrontPoint) => 3.5 + (most > fewest ? (5.5 * (point.turns + point.stops - fewest)) / (most - fewest) : 0);
  const rank = (point: FrontPoint) => (point.point === hovered ? 3 : point.point === open ? 2 : point.marks.length > 0 ? 1 : 0);
  // Small dots lie above large ones, those that stand out above all.
  const drawn = [...points].sort((a, b) => rank(a) - rank(b) || radius(b) - radius(a));

  // A finger is wider than a dot: the nearest one within reach is meant.
  const nearest = (event: MouseEvent & { currentTarget: SVGSVGElement }): number | null => {
    const box = event.currentTarget.getBoundingClientRect();
    const [px, py] = [((event.clientX - box.left) * W) / box.width, ((event.clientY - box.top) * H) / box.height];
    const away = (point: FrontPoint) => Math.hypot(x(point.overlap_m2 / size) - px, y(point.uncovered_m2 / size) - py);
    const best = points.reduce((a, b) => (away(b) < away(a) ? b : a));
    return away(best) <= (REACH_PX * W) / box.width ? best.point : null;
  };
  const step = (by: number) => {
    const at = points.findIndex((point) => point.point === (hovered ?? open));
    hover(points[Math.max(0, Math.min(points.length - 1, at < 0 ? 0 : at + by))]!.point);
  };
  const key = (event: KeyboardEvent) => {
    if (event.key === 'ArrowRight' || event.key === 'ArrowUp') step(1);
    else if (event.key === 'ArrowLeft' || event.key === 'ArrowDown') step(-1);
    else if ((event.key === 'Enter' || event.key === ' ') && hovered !== null) choose(hovered);
    else return;
    event.preventDefault();
  };
  return (
    <figure class="chart">
      <svg
        viewBox={`0 0 ${W} ${H}`} role="listbox" tabIndex={0} aria-activedescendant={hovered === null ? undefined : `${name}-${hovered}`}
        aria-label={t`Trade-off: overlap to the right, uncovered land upwards; a larger dot means more turns and stops. Arrow keys go from plan to plan, Enter shows one on the map.`}
        onMouseMove={(event) => hover(nearest(event))} onMouseLeave={() => hover(null)} onKeyDown={key}
        onClick={(event) => {
          const point = nearest(event);
          if (point !== null) choose(point);
        }}
      >
        {across.ticks.map((tick) => (
          <g key={tick}>
            <line class="rule" x1={x(tick)} x2={x(tick)} y1={TOP} y2={H - BOTTOM} />
            <text x={x(tick)} y={H - BOTTOM + 17} text-anchor="middle">{tickText(tick)}</text>
          </g>
        ))}
        {up.ticks.map((tick) => (
          <g key={tick}>
            <line class="rule" x1={LEFT} x2={W - RIGHT} y1={y(tick)} y2={y(tick)} />
            <text x={LEFT - 7} y={y(tick) + 4} text-anchor="end">{tickText(tick)}</text>
          </g>
        ))}
        <text x={W - RIGHT} y={H - 8} text-anchor="end">{t`Overlap, ${unit} →`}</text>
        <text x={LEFT + 6} y={TOP + 10}>{t`↑ Uncovered, ${unit}`}</text>
        {drawn.map((point) => (
          <g
            key={point.point} id={`${name}-${point.point}`} role="option" aria-selected={point.point === open}
            class={`dot ${point.point === open ? 'open' : ''} ${point.point === hovered ? 'hovered' : ''} ${point.marks.includes('given_prices') ? 'cheapest' : ''}`}
            aria-label={t`Plan ${point.point}: ${squareMetres(point.overlap_m2)} overlap, ${squareMetres(point.uncovered_m2)} uncovered, ${plural(point.turns, 'turn')}, ${plural(point.stops, 'stop')}, ${money(point.cost)}${point.marks.length > 0 ? `, ${marksOf(point)}` : ''}`}
          >
            <circle class="seen" cx={x(point.overlap_m2 / size)} cy={y(point.uncovered_m2 / size)} r={radius(point)} />
            {point.marks.includes('knee') && <circle class="knee" cx={x(point.overlap_m2 / size)} cy={y(point.uncovered_m2 / size)} r={radius(point) + 3.5} />}
          </g>
        ))}
      </svg>
      <figcaption class="hint">{t`A larger dot means more turns and stops. The filled dot is the cheapest at your prices, the ringed one is balanced.`}</figcaption>
    </figure>
  );
}
