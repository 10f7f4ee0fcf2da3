// The engine of the map is large: it is loaded after the first paint, and used once the map is there.
import type { Scale } from './grid';

type Engine = typeof import('./engine');
let loaded: Engine | null = null;
/** Null until the map is drawn. */
export const engine = () => loaded;

/** Draws the map in a box, which may be gone by the time the engine has come. */
export async function loadEngine(box: () => HTMLElement | null, scaled: (scale: Scale) => void): Promise<void> {
  const module = await import('./engine');
  const container = box();
  if (!container) return;
  await module.startMap(container, scaled);
  loaded = module;
  new ResizeObserver(() => module.resized()).observe(container);
}
