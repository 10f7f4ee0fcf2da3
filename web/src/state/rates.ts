// What work costs, by what the machine does.
import type { Operation, Prices, RateKey, Rates } from '../api/types';
import { store } from './store';
import { t } from '../words';

/** What is usual for each operation, for a machine as wide as the one of the form; empty until the server has said. */
export const usual = store<{ width_m: number; operations: Operation[] }>({ width_m: 0, operations: [] });

export const GENERAL = 'general';
export const usualOf = (rates: Rates | undefined, list: Operation[] = usual.get().operations): Operation | undefined =>
  list.find(({ operation }) => operation === (rates?.operation ?? GENERAL));

/** What land costs that is worked twice or missed, by the rates of a machine: prices of tracks that go with a plan of the whole job. */
export function landPrices(rates: Rates | undefined, usualPrices: Prices): Prices {
  const known = usualOf(rates)?.rates;
  if (!known) return usualPrices;
  const { input_price_per_ha, sections, margin_per_ha, price_per_stop } = { ...known, ...rates };
  return { ...usualPrices, overlap: input_price_per_ha / sections / 1e4, uncovered: margin_per_ha / 1e4, stop: price_per_stop };
}

/** As people call them. */
export const OPERATIONS: Record<string, string> = {
  general: t`Any work`, seeding: t`Seeding`, spraying: t`Spraying`, spreading: t`Spreading`, tillage: t`Tillage`, mowing: t`Mowing`, harvest: t`Harvest`,
  'robot weeding': t`Weeding by robot`, drone: t`Spraying by drone`,
};

export interface RateField {
  key: RateKey;
  label: string;
  unit: string;
  most: number;
  whole?: boolean;
}
/** Those that differ from farm to farm come first. */
export const RATES: RateField[] = [
  { key: 'price_per_hour', label: t`Machine and driver`, unit: '€/h', most: 1e5 },
  { key: 'fuel_l_per_h', label: t`Fuel at work`, unit: 'l/h', most: 1e4 },
  { key: 'fuel_price', label: t`Fuel`, unit: '€/l', most: 1e3 },
  { key: 'input_price_per_ha', label: t`Seed, spray, fertiliser`, unit: '€/ha', most: 1e6 },
  { key: 'margin_per_ha', label: t`Lost on missed land`, unit: '€/ha', most: 1e6 },
  { key: 'sections', label: t`Sections that switch`, unit: '', most: 1e4, whole: true },
  { key: 'price_per_stop', label: t`Stop and back out`, unit: '€', most: 1e5 },
];
/** Whether the same work was counted by the same prices; what fuel is used up follows from the machine. */
export function sameRates(a: Rates, b: Rates): boolean {
  return a.operation === b.operation && RATES.every(({ key }) => key === 'fuel_l_per_h' || a[key] === b[key]);
}
