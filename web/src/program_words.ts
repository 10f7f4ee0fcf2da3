// Sentences of the program in the language of the reader: the one place where they are known by their words.
import { PROGRAM } from './words';

interface Pattern {
  fits: RegExp;
  german: string;
}
let patterns: Pattern[] | null = null;

const plain = (text: string) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
const patternOf = ([english, german]: [string, string]): Pattern => ({
  fits: new RegExp(`^${english.split(/\{\d+\}/).map(plain).join('(.*?)')}$`, 's'),
  german,
});
const number = (text: string) => (/^-?\d+\.\d+$/.test(text) ? text.replace('.', ',') : text);

/** What the program says, as the page says it; a sentence that is not in the table stays as it is. */
export function told(message: string): string {
  if (PROGRAM === null) return message;
  patterns ??= Object.entries(PROGRAM).map(patternOf);
  const text = message.trim();
  if (text === '') return message;
  for (const { fits, german } of patterns) {
    const values = fits.exec(text);
    if (values) return german.replace(/\{(\d+)\}/g, (_, i: string) => number(told(values[Number(i) + 1]!)));
  }
  return message;
}
