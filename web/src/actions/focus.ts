// The keyboard always has a place. What had the focus may go away with what it did, as a button does that opens a field: then what was around it
// has the focus, and Tab goes on from there.

const PLACES = 'section[aria-label], section[aria-labelledby], [role=group][aria-label], form, main, nav';
/** From the inside out. */
let around: HTMLElement[] = [];

/** Whoever points, or turns to another window, has left by themselves. */
let left = true;

const lost = () => document.activeElement === null || document.activeElement === document.body;

function remember({ target }: FocusEvent): void {
  around = [];
  for (let at = (target as Element).closest<HTMLElement>(PLACES); at; at = at.parentElement?.closest<HTMLElement>(PLACES) ?? null) around.push(at);
}

/** What stands still over a panel that scrolls. */
const OVER = '.notices, .plan-bar, .sticky';
const MARGIN_PX = 8;
/** Scrolls what has the focus out from under it; a control that is drawn by its label is where that is. */
function uncover(focused: HTMLElement): void {
  const target = (focused.matches('.unseen') && (focused as HTMLInputElement).labels?.[0]) || focused;
  const panel = target.closest('.panel');
  if (!panel || target.contains(panel.firstElementChild)) return;
  for (const over of panel.querySelectorAll(OVER)) {
    const [box, cover] = [target.getBoundingClientRect(), over.getBoundingClientRect()];
    if (over.contains(target) || target.contains(over) || box.bottom <= cover.top || box.top >= cover.bottom) continue;
    panel.scrollBy(0, over.matches('.sticky') ? box.bottom - cover.top + MARGIN_PX : box.top - cover.bottom - MARGIN_PX);
  }
}
/** Something new that was asked for by a key, such as a field that was opened, has the focus where what asked for it is gone. */
export function takeFocus(place: HTMLElement | null): void {
  if (!left && place && (lost() || around.includes(document.activeElement as HTMLElement))) place.focus();
}

function find(): void {
  if (!lost()) return;
  const place = around.find((one) => one.isConnected && one.getClientRects().length > 0);
  if (!place) return;
  if (place.tabIndex < 0) place.tabIndex = -1;
  place.focus(); // scrolls it into sight
}

/** Something has the focus whenever something had it. */
export function keepFocus(): void {
  addEventListener('focusin', (event) => {
    remember(event);
    const target = event.target as HTMLElement;
    // The browser scrolls it into sight at the end of the frame, perhaps to below what stands still.
    if (!left) requestAnimationFrame(() => document.activeElement === target && uncover(target));
  });
  addEventListener('pointerdown', () => (left = true), true);
  addEventListener('keydown', () => (left = false), true);
  const look = () => {
    if (left) return;
    find();
    requestAnimationFrame(find); // what is disabled loses the focus in the next frame only
  };
  new MutationObserver(look).observe(document.getElementById('page')!, { childList: true, subtree: true, attributes: true, attributeFilter: ['disabled', 'hidden', 'open'] });
}
