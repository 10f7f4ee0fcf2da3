import { pause, play, seek, setSpeed, stopReplay } from '../../actions/play/replay';
import type { DriveFull, Meshes, WorkFigures } from '../../api/types';
import { clock, count, hectares, rate, squareMetres, timeOfDay } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { Figures } from '../../parts/figures';
import { Icon } from '../../parts/icon';
import { Slider } from '../../parts/slider';
import { replay } from '../../state/replay';
import { useStore } from '../../state/store';
import { t } from '../../words';

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

export function ReplayBar({ drive }: { drive: DriveFull }) {
  const state = useStore(replay, (value) => value);
  const mine = state.of === 'drive' && state.id === drive.id;
  const from = drive.from_s ?? 0;
  const to = drive.to_s ?? from + Math.max(1, drive.summary.fixes);
  const at = mine && state.time_s !== null ? state.time_s : from;
  const playing = mine && state.playing;
  return (
    <div class="replay" role="group" aria-label={t`Replay`}>
      <div class="row tight">
        <Button kind="main" aria-label={playing ? t`Pause the replay` : t`Play the drive`} onClick={() => (playing ? pause() : play(drive))}>
          <Icon name={playing ? 'pause' : 'play'} /> {playing ? t`Pause` : t`Play`}
        </Button>
        <Select label={t`Speed`} value={String(state.speed)} change={(value) => setSpeed(Number(value))}
          options={SPEEDS.map((speed) => ({ value: String(speed), label: `${speed} ×` }))} />
        {mine && <Button onClick={stopReplay}>{t`Result`}</Button>}
      </div>
      <Slider label={t`Time`} value={at - from} least={0} most={Math.max(1, to - from)} step="any" says={drive.clock === 'none' ? t`fix ${count(at)} of ${count(to)}` : t`${clock(at - from)} of ${clock(to - from)} h`}
        change={(value) => seek(drive, from + value)} />
      {mine && <p class="hint">{(drive.clock === 'utc' && timeOfDay(at)) || '\u00a0'}</p>}
      {mine && state.figures && <WorkNumbers figures={state.figures} />}
    </div>
  );
}

/** How many meshes the boundaries run through; none with the exact engine. */
export const meshFigures = (meshes: Meshes | undefined) =>
  !meshes ? [] : [
    { label: t`Meshes of ${meshes.side_m} m, covered`, value: count(meshes.covered.now), change: t`at most ${count(meshes.covered.most)}` },
    ...(meshes.missed ? [{ label: t`Meshes of ${meshes.side_m} m, missed`, value: count(meshes.missed.now), change: t`at most ${count(meshes.missed.most)}` }] : []),
  ];

/** What is not worked is missed when a drive is over; before, it is still to do. */
export const WorkNumbers = ({ figures: f, rest = t`Missed` }: { figures: WorkFigures; rest?: string }) => (
  <Figures label={t`Worked so far`}
    list={[
      { label: t`Covered`, value: hectares(f.covered_inside_m2 ?? f.covered_m2), tone: 'covered' },
      { label: t`Repeated`, value: squareMetres(f.repeated_m2), tone: 'overlap' },
      { label: rest, value: f.missed_m2 === null ? '–' : hectares(f.missed_m2), tone: 'uncovered' },
      { label: t`Rate`, value: rate(f.ha_per_hour) },
      { label: t`At work, h`, value: clock(f.worked_s) },
      { label: t`To go, h`, value: f.remaining_s === null ? '–' : clock(f.remaining_s) },
      ...meshFigures(f.meshes),
    ]} />
);
