// The keyboard always has a place. What had the focus may go away with what it did, as a button does that opens a field: then what was around it
// has the focus, and Tab goes on from there.

const PLACES = 'section[aria-label], section[aria-labelledby], [role=group][aria-label], form, main, nav';
/** From the inside out. */
let around: HTMLElement[] = [];

const lost = () => document.activeElement === null || document.activeElement === document.body;

function remember({ target }: FocusEvent): void {
  around = [];
  for (let at = (target as Element).closest<HTMLElement>(PLACES); at; at = at.parentElement?.closest<HTMLElement>(PLACES) ?? null) around.push(at);
}

function find(): void {
  if (!lost()) return;
  const place = around.find((one) => one.isConnected && one.getClientRects().length > 0);
  if (!place) return;
  if (place.tabIndex < 0) place.tabIndex = -1;
  place.focus({ preventScroll: true });
}

/** Something has the focus whenever something had it. */
export function keepFocus(): void {
  let left = false;
  addEventListener('focusin', remember);
  // Who clicks beside everything, or turns to another window, has left by themselves.
  addEventListener('pointerdown', () => (left = true), true);
  addEventListener('keydown', () => (left = false), true);
  // An element that is disabled loses the focus without a word, in the next frame.
  new MutationObserver(() => !left && requestAnimationFrame(find)).observe(document.getElementById('page')!, { childList: true, subtree: true, attributes: true, attributeFilter: ['disabled', 'hidden', 'open'] });
}
