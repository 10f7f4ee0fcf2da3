// An axis for areas from nothing to any size.

export interface Axis {
  /** 0 … 1 along the axis. */
  at: (value: number) => number;
  ticks: number[];
}

const ROUND = [0, ...[0.01, 0.1, 1, 10, 100, 1000, 10_000, 100_000, 1e6, 1e7].flatMap((power) => [1, 2, 5].map((n) => n * power))];
const LEAST_APART = 0.13;

/** Areas that are nothing but for rounding can be below 0; what is no number counts as nothing. */
const root = (value: number) => Math.sqrt(Number.isFinite(value) ? Math.max(0, value) : 0);

/** By the square root: most plans lie close together near the corner, a few far out. Of equal values all lie in the middle. */
export function axis(values: number[]): Axis {
  const roots = values.map(root);
  const [low, high] = [Math.min(...roots), Math.max(...roots)];
  // A span as wide as the rounding of what is written tells nothing.
  const span = Math.max(high - low, high / 20, 0.2);
  const middle = (low + high) / 2;
  const room = span * 0.06;
  const least = Math.max(0, Math.min(low, middle - span / 2) - room);
  const most = Math.max(high, middle + span / 2) + room;
  const at = (value: number) => (root(value) - least) / (most - least);
  const ticks: number[] = [];
  for (const tick of ROUND) {
    const last = ticks[ticks.length - 1];
    if (at(tick) >= 0 && at(tick) <= 1 && (last === undefined || at(tick) - at(last) >= LEAST_APART)) ticks.push(tick);
  }
  return { at, ticks };
}
