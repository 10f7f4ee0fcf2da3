// When the page has been seen. Effects run before that, and the start of the map keeps a slow machine busy for as long as all the rest takes.

/** A page in a tab that nobody looks at is not painted: it goes on without. */
const LONGEST_MS = 2000;

/** What the page holds now is in the next frame, and that is painted before the one after it. */
export const firstPaint = (): Promise<void> =>
  new Promise((resolve) => {
    setTimeout(resolve, LONGEST_MS);
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve)));
  });
