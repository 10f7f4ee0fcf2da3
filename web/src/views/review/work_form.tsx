// How a log is read and how its land is worked out: the options of an evaluation, for logs, feeds and drives.
import type { DriveOptions } from '../../api/types';
import { Choice, Select } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { t } from '../../words';

/** What the server takes where nothing is said (docs/coverage.md). */
const MESH_M = 0.05;
const USUAL = { max_gap_s: 10, max_step_m: 15, antenna_forward_m: 0, antenna_right_m: 0, implement_behind_m: 0 };

interface Props {
  options: DriveOptions;
  change: (options: DriveOptions) => void;
}

export function WorkForm({ options, change }: Props) {
  const set = (more: DriveOptions) => change({ ...options, ...more });
  const metres = (key: 'antenna_forward_m' | 'antenna_right_m' | 'implement_behind_m', label: string) => (
    <NumberField label={label} unit="m" value={options[key] ?? USUAL[key]} least={-100} most={100} change={(value) => value !== null && set({ [key]: value })} />
  );
  const most = (key: 'max_gap_s' | 'max_step_m', label: string, unit: string) => (
    <NumberField label={label} unit={unit} value={options[key] ?? USUAL[key]} least={0.1} most={100_000} change={(value) => value !== null && set({ [key]: value })} />
  );
  const text = (key: 'columns' | 'log_crs', label: string, example: string) => (
    <label class="field">
      <span class="label">{label}</span>
      <input type="text" autocomplete="off" placeholder={example} value={options[key] ?? ''} onInput={(event) => set({ [key]: event.currentTarget.value.trim() })} />
    </label>
  );
  return (
    <Expander title={t`How the land is worked out`}>
      <Choice label={t`Areas`} value={options.engine ?? 'exact'} change={(engine) => set({ engine })}
        options={[{ value: 'exact', label: t`Exact` }, { value: 'mesh', label: t`By meshes` }]}
        hint={options.engine === 'mesh' ? t`Boundaries are rounded to squares of this side, as in Zhang et al. 2023.` : ''} />
      {options.engine === 'mesh' && (
        <NumberField label={t`Side of a mesh`} unit="m" value={options.mesh_m ?? MESH_M} least={0.005} most={1}
          change={(mesh_m) => mesh_m !== null && set({ mesh_m })} />
      )}
      <Select label={t`Land between two fixes`} value={options.quads ?? 'heading'} change={(quads) => set({ quads })}
        options={[{ value: 'heading', label: t`square to the heading at both` }, { value: 'segment', label: t`a rectangle along the way` }]} />
      <Select label={t`Counts as repeated`} value={options.repeat ?? 'run'} change={(repeat) => set({ repeat })}
        options={[{ value: 'run', label: t`land worked again, not the inside of bends` }, { value: 'strict', label: t`all land worked twice or more` }]} />
      <Select label={t`Headings in the log`} value={options.headings ?? 'compass'} change={(headings) => set({ headings })}
        options={[
          { value: 'compass', label: t`clockwise from north` },
          { value: 'math', label: t`anticlockwise from east` },
          { value: 'from-track', label: t`not used: taken from the positions` },
        ]} />
      <Select label={t`Work switches`} value={options.switch ?? 'interpolate'} change={(value) => set({ switch: value })}
        options={[{ value: 'interpolate', label: t`half way between two fixes` }, { value: 'step', label: t`at the second of two fixes` }]} />
      <div class="two">
        {metres('antenna_forward_m', t`Antenna in front`)}
        {metres('antenna_right_m', t`Antenna to the right`)}
        {metres('implement_behind_m', t`Implement behind`)}
        {most('max_gap_s', t`Longest gap`, 's')}
        {most('max_step_m', t`Longest step`, 'm')}
      </div>
      {text('columns', t`Columns of the log`, 'lon=Xcoord,lat=Ycoord')}
      {text('log_crs', t`Coordinate system of the log`, 'EPSG:25832')}
    </Expander>
  );
}
