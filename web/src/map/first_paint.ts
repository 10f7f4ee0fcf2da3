// When the page has been seen. Effects run before that, and the start of the map keeps a slow machine busy for as long as all the rest takes.

/** A page in a tab that nobody looks at is not painted: it goes on without. */
const LONGEST_MS = 2000;

export const firstPaint = (): Promise<void> =>
  new Promise((resolve) => {
    setTimeout(resolve, LONGEST_MS);
    new PerformanceObserver((seen) => {
      if (seen.getEntriesByName('first-contentful-paint').length > 0) resolve();
    }).observe({ type: 'paint', buffered: true });
  });
