import type { Job } from '../api/types';
import { Button } from './button';

/** How far a job is, and a way out. */
export function Progress({ job, title, cancel }: { job: Job; title: string; cancel: () => void }) {
  const share = job.total > 0 ? job.done / job.total : null;
  return (
    <div class="progress" role="status">
      <div class="between">
        <span>{job.what ? `${title}: ${job.what}` : title}</span>
        {share !== null && <span class="number">{Math.round(share * 100)} %</span>}
      </div>
      {share === null ? <progress aria-label={title} /> : <progress aria-label={title} value={share} max={1} />}
      <Button onClick={cancel}>Cancel</Button>
    </div>
  );
}
