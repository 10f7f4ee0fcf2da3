import { useState } from 'preact/hooks';
import { goToStop, openExampleFarm } from '../../actions/example';
import { deleteField, openField } from '../../actions/fields';
import { attempt } from '../../actions/notices';
import { hectares, plural, when } from '../../format';
import { Button } from '../../parts/button';
import { ConfirmButton } from '../../parts/confirm_button';
import { Icon } from '../../parts/icon';
import { arrowKeys, LONG, matching, Search } from '../../parts/search';
import { fields } from '../../state/fields';
import { useStore } from '../../state/store';

export function FieldList() {
  const list = useStore(fields, (value) => value.list);
  const open = useStore(fields, (value) => value.open?.id);
  const [typed, setTyped] = useState('');
  if (list === null) return null;
  const long = list.length > LONG;
  const found = long ? matching(list, typed, (field) => `${field.name} ${hectares(field.area_m2)}`) : list;
  return (
    <section aria-labelledby="fields-title">
      <h2 id="fields-title">Your fields</h2>
      {list.length === 0 && (
        <>
          <p class="hint">None yet. Choose a file above, or draw a field on the map. To look round first:</p>
          <div class="row">
            <Button onClick={() => void attempt(openExampleFarm)}>Open the example farm</Button>
            <Button onClick={() => goToStop(0)}>Take the short tour</Button>
          </div>
        </>
      )}
      {long && <Search label="Search by name or area" typed={typed} found={found.length} all={list.length} list="stored-fields" change={setTyped} />}
      <ul class="cards" id="stored-fields" onKeyDown={arrowKeys}>
        {found.map((field) => (
          <li key={field.id} class="row tight">
            <button type="button" class="card grow" aria-current={field.id === open} onClick={() => void attempt(() => openField(field.id))}>
              <span class="grow">
                <strong>{field.name}</strong>
                <span class="sub">
                  {hectares(field.area_m2)}
                  {field.obstacles > 0 && ` · ${plural(field.obstacles, 'obstacle')}`}
                  {field.created && ` · ${when(field.created)}`}
                </span>
              </span>
            </button>
            <ConfirmButton label={`Delete ${field.name}`} ask="Delete it" act={() => void attempt(() => deleteField(field.id))}><Icon name="bin" /></ConfirmButton>
          </li>
        ))}
      </ul>
    </section>
  );
}
