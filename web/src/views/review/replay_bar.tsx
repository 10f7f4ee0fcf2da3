import { pause, play, seek, setSpeed, stopReplay } from '../../actions/replay';
import type { DriveFull, Meshes, WorkFigures } from '../../api/types';
import { clock, count, hectares, rate, squareMetres, timeOfDay } from '../../format';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { Figures } from '../../parts/figures';
import { Icon } from '../../parts/icon';
import { Slider } from '../../parts/slider';
import { replay } from '../../state/replay';
import { useStore } from '../../state/store';

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

export function ReplayBar({ drive }: { drive: DriveFull }) {
  const state = useStore(replay, (value) => value);
  const mine = state.of === 'drive' && state.id === drive.id;
  const from = drive.from_s ?? 0;
  const to = drive.to_s ?? from + Math.max(1, drive.summary.fixes);
  const at = mine && state.time_s !== null ? state.time_s : from;
  const playing = mine && state.playing;
  return (
    <div class="replay" role="group" aria-label="Replay">
      <div class="row tight">
        <Button kind="main" aria-label={playing ? 'Pause the replay' : 'Play the drive'} onClick={() => (playing ? pause() : play(drive))}>
          <Icon name={playing ? 'pause' : 'play'} /> {playing ? 'Pause' : 'Play'}
        </Button>
        <Select label="Speed" value={String(state.speed)} change={(value) => setSpeed(Number(value))}
          options={SPEEDS.map((speed) => ({ value: String(speed), label: `${speed} ×` }))} />
        {mine && <Button onClick={stopReplay}>Result</Button>}
      </div>
      <Slider label="Time" value={at - from} least={0} most={Math.max(1, to - from)} step="any" says={drive.clock === 'none' ? `fix ${count(at)} of ${count(to)}` : `${clock(at - from)} of ${clock(to - from)} h`}
        change={(value) => seek(drive, from + value)} />
      {mine && <p class="hint">{(drive.clock === 'utc' && timeOfDay(at)) || '\u00a0'}</p>}
      {mine && state.figures && <WorkNumbers figures={state.figures} />}
    </div>
  );
}

/** How many meshes the boundaries run through; none with the exact engine. */
export const meshFigures = (meshes: Meshes | undefined) =>
  !meshes ? [] : [
    { label: `Meshes of ${meshes.side_m} m, covered`, value: count(meshes.covered.now), change: `at most ${count(meshes.covered.most)}` },
    ...(meshes.missed ? [{ label: `Meshes of ${meshes.side_m} m, missed`, value: count(meshes.missed.now), change: `at most ${count(meshes.missed.most)}` }] : []),
  ];

/** What is not worked is missed when a drive is over; before, it is still to do. */
export const WorkNumbers = ({ figures: f, rest = 'Missed' }: { figures: WorkFigures; rest?: 'Missed' | 'Still to do' }) => (
  <Figures label="Worked so far"
    list={[
      { label: 'Covered', value: hectares(f.covered_inside_m2 ?? f.covered_m2), tone: 'covered' },
      { label: 'Repeated', value: squareMetres(f.repeated_m2), tone: 'overlap' },
      { label: rest, value: f.missed_m2 === null ? '–' : hectares(f.missed_m2), tone: 'uncovered' },
      { label: 'Rate', value: rate(f.ha_per_hour) },
      { label: 'At work, h', value: clock(f.worked_s) },
      { label: 'To go, h', value: f.remaining_s === null ? '–' : clock(f.remaining_s) },
      ...meshFigures(f.meshes),
    ]} />
);
