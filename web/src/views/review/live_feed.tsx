// Attaching to a machine that is at work.
import { useEffect, useState } from 'preact/hooks';
import { endFeed, runningFeeds, switchWork, watch } from '../../actions/feeds';
import { attempt } from '../../actions/notices';
import { attach, stopReplay } from '../../actions/play/replay';
import type { DriveOptions, FeedItem } from '../../api/types';
import { Button } from '../../parts/button';
import { Select } from '../../parts/choice';
import { Expander } from '../../parts/expander';
import { NumberField } from '../../parts/number_field';
import { Switch } from '../../parts/switch';
import { fields } from '../../state/fields';
import { form } from '../../state/plan_form';
import { replay } from '../../state/replay';
import { useStore } from '../../state/store';
import { CabFigures } from './cab_figures';
import { WorkNumbers } from './replay_bar';
import { WorkForm } from './work_form';
import { t } from '../../words';

type Kind = 'tcp' | 'udp' | 'gpsd' | 'serial' | 'file';
const KINDS: Record<Kind, { label: string; where: string; example: string }> = {
  tcp: { label: t`Network (TCP)`, where: t`Host and port`, example: '192.168.1.20:9000' },
  udp: { label: t`Network (UDP)`, where: t`Port`, example: ':4001' },
  gpsd: { label: 'gpsd', where: t`Host and port`, example: 'localhost:2947' },
  serial: { label: t`Serial port`, where: t`Device and speed`, example: '/dev/ttyUSB0,115200' },
  file: { label: t`File being written`, where: t`Path on the server’s computer`, example: '/home/somebody/today.csv' },
};

export function StartFeed() {
  const list = useStore(fields, (value) => value.list) ?? [];
  const [kind, setKind] = useState<Kind>('tcp');
  const [where, setWhere] = useState('');
  const [field, setField] = useState(fields.get().open?.id ?? '');
  const [width_m, setWidth] = useState<number | null>(form.get().machine.width_m);
  const [options, setOptions] = useState<DriveOptions>({});
  const [running, setRunning] = useState<FeedItem[]>([]);
  useEffect(() => {
    void runningFeeds().then(setRunning);
  }, []);
  const go = () =>
    watch({
      source: `${kind}://${where.trim()}`,
      ...(field ? { field } : {}),
      ...(width_m === null ? {} : { width_m }),
      ...(Object.keys(options).length === 0 ? {} : { options }),
    });
  const { where: asked, example } = KINDS[kind];
  return (
    <>
      {running.map((feed) => (
        <div key={feed.id} class="row"><Button onClick={() => attach(feed)}>{t`Watch ${feed.name ?? feed.source ?? feed.id}`}</Button></div>
      ))}
      <Expander title={t`Watch a machine at work`}>
        <form onSubmit={(event) => { event.preventDefault(); void attempt(go); }}>
          <Select label={t`Connection`} value={kind} change={setKind}
            options={(Object.keys(KINDS) as Kind[]).map((value) => ({ value, label: KINDS[value].label }))} />
          <label class="field">
            <span class="label">{asked}</span>
            <input type="text" autocomplete="off" placeholder={example} value={where} onInput={(event) => setWhere(event.currentTarget.value)} />
          </label>
          <Select label={t`Field`} value={field} change={setField}
            options={[{ value: '', label: t`none` }, ...list.map((one) => ({ value: one.id, label: one.name }))]} />
          <NumberField label={t`Working width`} unit="m" value={width_m} least={0.2} most={100} optional hint={t`If left empty: as the machine says.`} change={setWidth} />
          <WorkForm options={options} change={setOptions} />
          <button type="submit" class="button main" disabled={where.trim() === ''}>{t`Watch it`}</button>
        </form>
      </Expander>
    </>
  );
}

export function LiveFeed() {
  const state = useStore(replay, (value) => value);
  const [work, setWork] = useState(true);
  const id = state.id;
  if (id === null) return null;
  const toggle = async () => {
    await switchWork(id, !work);
    setWork(!work);
  };
  return (
    <section class="open" aria-labelledby="live-title">
      <h2 id="live-title">{state.name}</h2>
      <p class={state.connected ? 'fine' : 'fault'} role="status">
        {state.message ?? (state.figures ? (state.working ? t`At work.` : t`Connected, not working.`) : t`Waiting for the first fix …`)}
      </p>
      <CabFigures />
      {state.figures && <WorkNumbers figures={state.figures} rest={t`Still to do`} />}
      <Switch on={state.follows} label={t`Keep the machine in the middle of the map`} change={(follows) => replay.set({ follows })} />
      <div class="row">
        <Button onClick={() => void attempt(toggle)}>{work ? t`Mark as not working` : t`Mark as working again`}</Button>
        <Button kind="main" onClick={() => void attempt(() => endFeed(id))}>{t`Stop and store the drive`}</Button>
        <Button onClick={stopReplay}>{t`Leave it running`}</Button>
      </div>
    </section>
  );
}
