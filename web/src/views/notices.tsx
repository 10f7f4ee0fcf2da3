import { dismiss } from '../actions/notices';
import { AWAY } from '../api/errors';
import { Icon } from '../parts/icon';
import { notices } from '../state/notices';
import { session } from '../state/session';
import { useStore } from '../state/store';
import { t } from '../words';

export function Notices() {
  const list = useStore(notices, (value) => value.list);
  const reachable = useStore(session, (value) => value.reachable);
  return (
    <div class="notices" aria-live="polite">
      {!reachable && <div class="notice error away" role="alert"><p>{AWAY}</p></div>}
      {list.map((notice) => (
        <div key={notice.number} class={`notice ${notice.kind}`} role={notice.kind === 'error' ? 'alert' : 'status'}>
          <p>{notice.text}</p>
          <button type="button" class="button quiet square" aria-label={t`Dismiss this message`} onClick={() => dismiss(notice.number)}>
            <Icon name="close" />
          </button>
        </div>
      ))}
    </div>
  );
}
