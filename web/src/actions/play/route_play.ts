// Driving a route on the screen.
import type { Route } from '../../api/types';
import { routePlay } from '../../state/route_play';

let frame = 0;
let before_ms = 0;

function step(route: Route, now_ms: number): void {
  const { playing, at_s, speed } = routePlay.get();
  if (!playing) return;
  const next = at_s + ((now_ms - before_ms) / 1000) * speed;
  before_ms = now_ms;
  if (next >= route.time_s) return routePlay.set({ at_s: route.time_s, playing: false });
  routePlay.set({ at_s: next });
  frame = requestAnimationFrame((ms) => step(route, ms));
}

export function playRoute(plan: string, route: Route): void {
  const { plan: last, at_s } = routePlay.get();
  const goesOn = last === plan && at_s < route.time_s;
  routePlay.set({ plan, at_s: goesOn ? at_s : 0, playing: true });
  cancelAnimationFrame(frame);
  before_ms = performance.now();
  frame = requestAnimationFrame((ms) => step(route, ms));
}
export const pauseRoute = () => routePlay.set({ playing: false });
export const seekRoute = (plan: string, at_s: number) => routePlay.set({ plan, at_s });
export const leaveRoute = () => routePlay.set({ plan: null, at_s: 0, playing: false });
