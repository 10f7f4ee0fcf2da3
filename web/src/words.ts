// What the page says, in the language of its reader. English stands where it is used; german.ts has the German of each sentence beside it.

export type Language = 'en' | 'de';

/** What the browser keeps a chosen language under. */
export const LANGUAGE_KEY = 'tramline-language';
function remembered(): Language | null {
  const kept = localStorage.getItem(LANGUAGE_KEY);
  return kept === 'en' || kept === 'de' ? kept : null;
}
/** The one that was chosen, else the first of the browser's that the page speaks. */
const spoken = (): Language => {
  for (const name of navigator.languages) {
    if (name.startsWith('de')) return 'de';
    if (name.startsWith('en')) return 'en';
  }
  return 'en';
};
export const language: Language = remembered() ?? spoken();
/** How numbers and dates are written. */
export const locale = language === 'de' ? 'de-DE' : 'en-GB';
document.documentElement.lang = language;

const german = language === 'de' ? await import('./german') : null;
const table: Readonly<Record<string, string>> | null = german && german.GERMAN;
/** What the program says, see program_words.ts. */
export const PROGRAM: Readonly<Record<string, string>> | null = german && german.PROGRAM;

/** A word or sentence of the table; what is not in it stays as it is. */
export function said(english: string): string {
  if (table === null) return english;
  const [, before, core, after] = /^(\s*)([\s\S]*?)(\s*)$/.exec(english)!;
  return before + (table[core!] ?? core!) + after;
}

const known = new WeakMap<TemplateStringsArray, string>();
/** A sentence with values in it, by the place that each has in the German one: {0}, {1} … */
export function t(parts: TemplateStringsArray, ...values: unknown[]): string {
  let sentence = known.get(parts);
  if (sentence === undefined) {
    sentence = said(parts.reduce((all, part, i) => `${all}{${i - 1}}${part}`));
    known.set(parts, sentence);
  }
  return values.length === 0 ? sentence : sentence.replace(/\{(\d+)\}/g, (_, i: string) => String(values[Number(i)]));
}
