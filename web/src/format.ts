// How numbers and sentences are written, everywhere on the page.

const whole = new Intl.NumberFormat('en-GB', { maximumFractionDigits: 0 });
const fixed = [0, 1, 2, 3].map(
  (digits) => new Intl.NumberFormat('en-GB', { minimumFractionDigits: digits, maximumFractionDigits: digits }),
);
const NONE = '–';
type Maybe = number | null | undefined;
const missing = (value: Maybe): value is null | undefined => value === null || value === undefined || !Number.isFinite(value);
const zeroed = (text: string) => (/^-0(\.0+)?$/.test(text) ? text.slice(1) : text.replace('-', '−'));
const digits = (value: number, places: number) => zeroed((fixed[places] ?? whole).format(value));

export const count = (value: Maybe) => (missing(value) ? NONE : digits(value, 0));
export const hectares = (m2: Maybe) => (missing(m2) ? NONE : `${digits(m2 / 1e4, 2)} ha`);
/** Areas to compare with one another: m², finer where they are small. */
export const squareMetres = (m2: Maybe) => (missing(m2) ? NONE : `${digits(m2, Math.abs(m2) < 10 ? 1 : 0)} m²`);
/** Areas of any size, by themselves: m² up to ten hectares. */
export const area = (m2: Maybe) => (missing(m2) || Math.abs(m2) < 1e5 ? squareMetres(m2) : hectares(m2));
export const metres = (m: Maybe) => (missing(m) ? NONE : `${digits(m, Math.abs(m) < 10 ? 2 : 0)} m`);
export const width = (m: Maybe) => (missing(m) ? NONE : `${zeroed(String(Math.round(m * 100) / 100))} m`);
export const length = (m: Maybe) => (missing(m) ? NONE : Math.abs(m) < 10_000 ? metres(m) : `${digits(m / 1000, 1)} km`);
/** How far off something is, in words' precision: 420 m, 12 km, 7,480 km. */
export const farness = (m: number) => (m < 1000 ? `${digits(Math.max(10, Math.round(m / 10) * 10), 0)} m` : m < 10_000 ? `${digits(m / 1000, 1)} km` : `${digits(m >= 1e5 ? Math.round(m / 1e4) * 10 : m / 1000, 0)} km`);
/** Cents matter up to a hundred thousand. */
export const money = (value: Maybe) =>
  missing(value) ? NONE : `€${digits(value, Math.abs(value) < 1e5 ? 2 : 0)}`.replace('€−', '−€');
export const percent = (share: Maybe) => (missing(share) ? NONE : `${digits(share * 100, 1)}\u00a0%`);
export const hours = (h: Maybe) => (missing(h) ? NONE : `${digits(h, 2)} h`);
export const litres = (l: Maybe) => (missing(l) ? NONE : `${digits(l, Math.abs(l) < 10 ? 1 : 0)} l`);
export const speed = (mps: Maybe) => (missing(mps) ? NONE : `${digits(mps * 3.6, 1)} km/h`);
export const rate = (ha_per_hour: Maybe) => (missing(ha_per_hour) ? NONE : `${digits(ha_per_hour, 1)} ha/h`);
export const degrees = (deg: Maybe) => (missing(deg) ? NONE : `${digits(deg, 1)}°`);

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

export const plural = (n: number, one: string, many = `${one}s`) => `${count(n)} ${n === 1 ? one : many}`;
export const megabytes = (bytes: number) => `${digits(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB`;

export function when(created: string | number | null | undefined): string {
  if (created === null || created === undefined) return '';
  const date = new Date(typeof created === 'number' ? created * 1000 : created);
  if (Number.isNaN(date.getTime())) return String(created);
  return date.toLocaleString('en-GB', { day: 'numeric', month: 'short', hour: '2-digit', minute: '2-digit' });
}

const ENDS: Record<string, string> = {
  cheapest: 'cheapest',
  centre: 'at the centre line',
  cover: 'cover everything',
  inside: 'stay inside',
};
export const endRule = (rule: string) => ENDS[rule] ?? rule;

/** The library's messages begin in lower case and bear no full stop. */
export function sentence(message: string): string {
  const text = message.trim();
  if (text === '') return text;
  const whole = /[.!?…]$/.test(text) ? text : `${text}.`;
  return /^[a-z]+\b(?![./_])/.test(whole) ? whole[0]!.toUpperCase() + whole.slice(1) : whole;
}
