// How numbers and sentences are written, everywhere on the page.
import { inFeet, measures, unitOf } from './measures';
import { locale, said, t } from './words';

const whole = new Intl.NumberFormat(locale, { maximumFractionDigits: 0 });
const fixed = [0, 1, 2, 3, 4].map(
  (digits) => new Intl.NumberFormat(locale, { minimumFractionDigits: digits, maximumFractionDigits: digits }),
);
const NONE = '–';
type Maybe = number | null | undefined;
const missing = (value: Maybe): value is null | undefined => value === null || value === undefined || !Number.isFinite(value);
const zeroed = (text: string) => (/^-0([.,]0+)?$/.test(text) ? text.slice(1) : text.replace('-', '−'));
const digits = (value: number, places: number) => zeroed((fixed[places] ?? whole).format(value));
/** A value in metres, litres … in the unit that the reader has for it, with so many digits as its size asks for. */
function inUnit(value: number, unit: string, places: (shown: number) => number): string {
  const { name, size } = unitOf(unit);
  const shown = value / size;
  return `${digits(shown, places(Math.abs(shown)))} ${name}`;
}

export const count = (value: Maybe) => (missing(value) ? NONE : digits(value, 0));
export const hectares = (m2: Maybe) => (missing(m2) ? NONE : inUnit(m2 / 1e4, 'ha', () => 2));
/** Areas to compare with one another: m², finer where they are small. */
export const squareMetres = (m2: Maybe) => (missing(m2) ? NONE : inUnit(m2, 'm²', (size) => (size < 10 ? 1 : 0)));
/** Areas of any size, by themselves: m² up to ten hectares. */
export const area = (m2: Maybe) => (missing(m2) || Math.abs(m2) < (inFeet() ? 1e4 : 1e5) ? squareMetres(m2) : hectares(m2));
export const metres = (m: Maybe) => (missing(m) ? NONE : inUnit(m, 'm', (size) => (size < 10 ? 2 : 0)));
/** A width of a machine: as exact as it was typed. */
export const width = (m: Maybe) => (missing(m) ? NONE : `${typed(Math.round((m / unitOf('m').size) * 100) / 100)} ${unitOf('m').name}`);
export const length = (m: Maybe) => (missing(m) ? NONE : Math.abs(m) < 10_000 ? metres(m) : inUnit(m / 1000, 'km', () => 1));
/** How far off something is, in words' precision: 420 m, 12 km, 7,480 km. */
export function farness(m: number): string {
  const small = unitOf('m');
  const steps = Math.max(10, Math.round(m / small.size / 10) * 10);
  return m < 1000 ? `${digits(steps, 0)} ${small.name}` : inUnit(m >= 1e5 ? Math.round(m / 1e4) * 10 : m / 1000, 'km', () => (m < 10_000 ? 1 : 0));
}
/** Cents matter up to a hundred thousand. */
export function money(euros: Maybe): string {
  if (missing(euros)) return NONE;
  const { per_euro } = measures.get();
  return inCurrency(euros * per_euro, Math.abs(euros * per_euro) < 1e5 ? 2 : 0);
}
function inCurrency(amount: number, places: number): string {
  const { currency } = measures.get();
  const style = { style: 'currency', currency, currencyDisplay: 'narrowSymbol', minimumFractionDigits: places, maximumFractionDigits: places } as const;
  const text = new Intl.NumberFormat(locale, style).format(amount);
  return Number(amount.toFixed(places)) === 0 ? text.replace('-', '') : text.replace('-', '−');
}
/** The price of a square metre, of which a hundredth of a cent may matter. */
export function moneyPerArea(euros_per_m2: number): string {
  const { name, size } = unitOf('m²');
  const amount = euros_per_m2 * measures.get().per_euro * size;
  return `${inCurrency(amount, amount === 0 || amount >= 0.01 ? 2 : 4)} / ${name}`;
}
export const percent = (share: Maybe) => (missing(share) ? NONE : `${digits(share * 100, 1)}\u00a0%`);
export const hours = (h: Maybe) => (missing(h) ? NONE : `${digits(h, 2)} h`);
export const litres = (l: Maybe) => (missing(l) ? NONE : inUnit(l, 'l', (size) => (size < 10 ? 1 : 0)));
export const speed = (mps: Maybe) => (missing(mps) ? NONE : inUnit(mps * 3.6, 'km/h', () => 1));
export const rate = (ha_per_hour: Maybe) => (missing(ha_per_hour) ? NONE : inUnit(ha_per_hour, 'ha/h', () => 1));
export const degrees = (deg: Maybe) => (missing(deg) ? NONE : `${digits(deg, 1)}°`);

/** A number as one types it: no thousands, the decimal sign of the language. */
export const typed = (value: number) => (locale === 'de-DE' ? String(value).replace('.', ',') : String(value)).replace('-', '−');

/** 3725 s: "1:02:05". */
export function clock(seconds: Maybe): string {
  if (missing(seconds)) return NONE;
  const s = Math.max(0, Math.round(seconds));
  const two = (n: number) => String(n).padStart(2, '0');
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

/** Time of day of a log whose clock counts from 1970, UTC. */
export function timeOfDay(seconds: Maybe): string {
  if (missing(seconds) || seconds < 1e8) return '';
  return `${new Date(seconds * 1000).toISOString().slice(0, 19).replace('T', ' ')} UTC`;
}

/** A difference, with its sign: "+210 m²", "−3", "±0". */
export function change(difference: number, write: (value: number) => string): string {
  const size = write(Math.abs(difference));
  if (size === write(0)) return '±0';
  return `${difference > 0 ? '+' : '−'}${size}`;
}

/** Both forms are words of the table. */
export const plural = (n: number, one: string, many = `${one}s`) => `${count(n)} ${said(n === 1 ? one : many)}`;
export const megabytes = (bytes: number) => `${digits(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB`;

export function when(created: string | number | null | undefined): string {
  if (created === null || created === undefined) return '';
  const date = new Date(typeof created === 'number' ? created * 1000 : created);
  if (Number.isNaN(date.getTime())) return String(created);
  return date.toLocaleString(locale, { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit' });
}

const ENDS: Record<string, string> = {
  cheapest: t`cheapest`,
  centre: t`at the centre line`,
  cover: t`cover everything`,
  inside: t`stay inside`,
};
export const endRule = (rule: string) => ENDS[rule] ?? rule;

/** The library's messages begin in lower case and bear no full stop. */
export function sentence(message: string): string {
  const text = message.trim();
  if (text === '') return text;
  const whole = /[.!?…]$/.test(text) ? text : `${text}.`;
  return /^[a-z]+\b(?![./_])/.test(whole) ? whole[0]!.toUpperCase() + whole.slice(1) : whole;
}
