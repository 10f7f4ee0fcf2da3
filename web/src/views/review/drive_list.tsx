import { deleteDrive, openDrive } from '../../actions/drives';
import { attempt } from '../../actions/notices';
import { count, hectares, when } from '../../format';
import { ConfirmButton } from '../../parts/confirm_button';
import { Icon } from '../../parts/icon';
import { review } from '../../state/review';
import { useStore } from '../../state/store';
import { t } from '../../words';

export function DriveList() {
  const list = useStore(review, (value) => value.list);
  const open = useStore(review, (value) => value.drive?.id);
  if (list === null) return null;
  return (
    <section aria-labelledby="drives-title">
      <h2 id="drives-title">{t`Your drives`}</h2>
      {list.length === 0 && <p class="hint">{t`None yet. Choose a log above, or watch a machine that is at work.`}</p>}
      <ul class="cards">
        {list.map((drive) => (
          <li key={drive.id} class="row tight">
            <button type="button" class="card grow" aria-current={drive.id === open} onClick={() => void attempt(() => openDrive(drive.id))}>
              <span class="grow">
                <strong>{drive.name}</strong>
                <span class="sub">{t`${hectares(drive.covered_m2)} covered · ${count(drive.fixes)} fixes`} · {when(drive.created)}</span>
              </span>
            </button>
            <ConfirmButton label={t`Delete ${drive.name}`} ask={t`Delete it`} act={() => void attempt(() => deleteDrive(drive.id))}><Icon name="bin" /></ConfirmButton>
          </li>
        ))}
      </ul>
    </section>
  );
}
