import type { Job } from '../api/types';
import { Button } from './button';
import { t } from '../words';

const TELLING = 0.1;
const LEAST_S = 2;
/** As long as the rest takes at the pace so far; null while that says nothing. */
function timeLeft(share: number, seconds: number): string | null {
  if (share < TELLING || seconds < LEAST_S) return null;
  const left = (seconds * (1 - share)) / share;
  return left < 1 ? t`Nearly done.` : left < 90 ? t`About ${Math.ceil(left)} s left.` : t`About ${Math.ceil(left / 60)} min left.`;
}

/** How far a job is, and a way out. */
export function Progress({ job, title, cancel }: { job: Job; title: string; cancel: () => void }) {
  const share = job.total > 0 ? job.done / job.total : null;
  const left = share === null ? null : timeLeft(share, job.seconds);
  return (
    <div class="progress" role="status">
      <div class="between">
        <span>{job.what ? `${title}: ${job.what}` : title}</span>
        {share !== null && <span class="number">{Math.floor(share * 100)} %</span>}
      </div>
      <p class="hint">{left ?? (job.state === 'queued' ? t`Waiting for other work.` : t`${Math.round(job.seconds)} s so far.`)}</p>
      {share === null ? <progress aria-label={title} /> : <progress aria-label={title} value={share} max={1} />}
      <Button onClick={cancel}>{t`Cancel`}</Button>
    </div>
  );
}
