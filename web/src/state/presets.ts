// Machines as people speak of them, to start from: about as wide, as nimble and as long as the usual ones. Lengths are those of examples/machines.
import type { Machine } from '../api/types';
import { FOOT_M, type System } from '../measures';
import { t } from '../words';

export interface Preset {
  key: string;
  label: string;
  system: System;
  machine: Machine;
}

const feet = (ft: number) => Math.round(ft * FOOT_M * 1e4) / 1e4;
const TRACTOR = { front_overhang_m: 3.9, vehicle_width_m: 2.55 };
const mounted = (offset_m: number, rear_m: number) => ({ reverse: true, implement: 'mounted', implement_offset_m: offset_m, rear_overhang_m: rear_m, ...TRACTOR });
const towed = (drawbar_m: number, rear_m: number) => ({ implement: 'towed', implement_offset_m: 1, drawbar_m, rear_overhang_m: rear_m, ...TRACTOR });
const COMBINE = { reverse: true, implement: 'mounted', implement_offset_m: -3.5, rear_overhang_m: 1.5, front_overhang_m: 3.5, vehicle_width_m: 3.5 };

const one = (key: string, system: System, label: string, width_m: number, radius_m: number, operation: string, turning: Record<string, unknown>, sections?: number): Preset => ({
  key, label, system, machine: { width_m, radius_m, turning, rates: { operation, ...(sections === undefined ? {} : { sections }) } },
});

export const PRESETS: Preset[] = [
  one('drill-3', 'metric', t`Seed drill, 3 m`, 3, 5.5, 'seeding', { ...mounted(2, 0.8), lift_m: 1, lower_m: 1 }),
  one('planter-8', 'metric', t`Planter, 8 rows of 75 cm`, 6, 6.5, 'seeding', { ...mounted(1.8, 0.6), lift_m: 1, lower_m: 1.5 }, 8),
  one('sprayer-24', 'metric', t`Mounted sprayer, 24 m`, 24, 6, 'spraying', mounted(2, 0.3), 8),
  one('sprayer-36', 'metric', t`Trailed sprayer, 36 m`, 36, 7.5, 'spraying', towed(5.5, 1.5), 12),
  one('spreader-24', 'metric', t`Fertiliser spreader, 24 m`, 24, 6, 'spreading', mounted(1.6, 0.6)),
  one('cultivator-4', 'metric', t`Cultivator, 4 m`, 4, 6, 'tillage', { ...mounted(2.5, 1.2), lift_m: 1, lower_m: 1 }),
  one('mower-9', 'metric', t`Mower combination, 9 m`, 9, 6, 'mowing', mounted(1.8, 0.7)),
  one('combine-9', 'metric', t`Combine, 9 m header`, 9, 7, 'harvest', COMBINE),
  one('planter-16', 'us', t`Planter, 16 rows of 30 in`, feet(40), feet(25), 'seeding', towed(6, 1), 16),
  one('seeder-60', 'us', t`Air seeder, 60 ft`, feet(60), feet(30), 'seeding', towed(9, 2)),
  one('sprayer-120', 'us', t`Self-propelled sprayer, 120 ft`, feet(120), feet(25), 'spraying', { reverse: true, implement: 'mounted', implement_offset_m: 1.5, front_overhang_m: 4.5, vehicle_width_m: 3.8 }, 12),
  one('spreader-80', 'us', t`Spreader, 80 ft`, feet(80), feet(22), 'spreading', towed(4.5, 1)),
  one('cultivator-40', 'us', t`Field cultivator, 40 ft`, feet(40), feet(27), 'tillage', towed(6, 2)),
  one('combine-40', 'us', t`Combine, 40 ft draper`, feet(40), feet(23), 'harvest', COMBINE),
  one('combine-12', 'us', t`Combine, 12 rows of 30 in`, feet(30), feet(23), 'harvest', COMBINE),
  one('robot-weeder', 'metric', t`Field robot, 1.5 m`, 1.5, 2, 'robot weeding', {
    reverse: true, implement: 'mounted', implement_offset_m: 0.4, rear_overhang_m: 0.3, front_overhang_m: 1.4, vehicle_width_m: 1.5, working_speed_mps: 1, turning_speed_mps: 0.8, reverse_speed_mps: 0.8,
  }),
  one('drone', 'metric', t`Spray drone, 5 m`, 5, 0.5, 'drone', { turning_speed_mps: 2.5, front_overhang_m: 0.8, vehicle_width_m: 1.6 }),
];

/** The machines of the reader's units first. */
export const presetsFor = (system: System): Preset[] => [...PRESETS.filter((preset) => preset.system === system), ...PRESETS.filter((preset) => preset.system !== system)];

const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);
/** The preset that a machine is, as long as nothing of it was changed. */
export const presetOf = ({ width_m, radius_m, turning, rates, min_length_m }: Machine): Preset | undefined =>
  PRESETS.find(({ machine }) => machine.width_m === width_m && machine.radius_m === radius_m && same(machine.turning, turning) && same(machine.rates, rates) && typeof min_length_m !== 'number');
