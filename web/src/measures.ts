// Units and money as the reader counts them. The server counts in metres, litres and euros.
import { store } from './state/store';

export type System = 'metric' | 'us';
export const CURRENCIES = ['EUR', 'USD', 'GBP', 'CHF', 'PLN', 'CZK', 'SEK', 'DKK', 'CAD', 'AUD', 'BRL'] as const;
export type Currency = (typeof CURRENCIES)[number];

/** About what a euro is worth, to start from: users type the rate of the day. */
export const ABOUT: Record<Currency, number> = { EUR: 1, USD: 1.15, GBP: 0.87, CHF: 0.94, PLN: 4.25, CZK: 24.5, SEK: 11, DKK: 7.46, CAD: 1.6, AUD: 1.75, BRL: 6.3 };

interface Measures {
  system: System;
  currency: Currency;
  /** How much of the currency a euro is worth. */
  per_euro: number;
}
const KEEP = 'tramline-measures';
const USUAL: Measures = { system: 'metric', currency: 'EUR', per_euro: 1 };

function kept(): Measures {
  try {
    const own = { ...USUAL, ...(JSON.parse(localStorage.getItem(KEEP) ?? '{}') as Partial<Measures>) };
    const sound = (own.system === 'metric' || own.system === 'us') && CURRENCIES.includes(own.currency) && own.per_euro > 0 && Number.isFinite(own.per_euro);
    return sound ? own : USUAL;
  } catch {
    return USUAL;
  }
}
export const measures = store<Measures>(kept());
measures.listen(() => localStorage.setItem(KEEP, JSON.stringify(measures.get())));

export const FOOT_M = 0.3048;
export const MILE_M = 5280 * FOOT_M;
export const SQUARE_FOOT_M2 = FOOT_M * FOOT_M;
export const ACRE_M2 = 43_560 * SQUARE_FOOT_M2;
export const GALLON_L = 3.785411784;
export const inFeet = () => measures.get().system === 'us';

/** A unit of the reader's, and how many of the server's it is. */
export interface Unit {
  name: string;
  size: number;
}
const US: Record<string, Unit> = {
  m: { name: 'ft', size: FOOT_M }, km: { name: 'mi', size: MILE_M / 1000 }, 'm²': { name: 'ft²', size: SQUARE_FOOT_M2 },
  ha: { name: 'ac', size: ACRE_M2 / 1e4 }, l: { name: 'gal', size: GALLON_L }, 'km/h': { name: 'mph', size: MILE_M / 1000 },
};

/** The sign of the currency: "€". */
export function currencySign(): string {
  const { currency } = measures.get();
  return new Intl.NumberFormat('en-GB', { style: 'currency', currency, currencyDisplay: 'narrowSymbol' }).formatToParts(0).find(({ type }) => type === 'currency')?.value ?? currency;
}

/** What takes the place of a unit such as "m", "€/ha" or "l/h". */
export function unitOf(unit: string): Unit {
  const whole = inFeet() ? US[unit] : undefined;
  if (whole) return whole;
  const [over, under] = unit.split('/');
  if (under !== undefined) {
    const [a, b] = [unitOf(over!), unitOf(under)];
    return { name: `${a.name}/${b.name}`, size: a.size / b.size };
  }
  return unit === '€' ? { name: currencySign(), size: 1 / measures.get().per_euro } : { name: unit, size: 1 };
}
