// A code that opens this plan on the phone beside it.
import { useState } from 'preact/hooks';
import { encode } from 'uqr';
import { attempt } from '../../actions/notices';
import { api } from '../../api/client';
import type { PlanFull } from '../../api/types';
import { Button } from '../../parts/button';
import { t } from '../../words';

/** The address of the plan, as the page is reached from elsewhere. */
function addressOf(base: string, plan: PlanFull): string {
  const opened = new URLSearchParams({ view: 'plan', field: plan.field, plan: plan.id }).toString();
  return base.includes('#') ? `${base}&${opened}` : `${base}#${opened}`;
}

function Code({ text }: { text: string }) {
  const { data, size } = encode(text, { border: 2 });
  const d = data.flatMap((row, y) => row.map((dark, x) => (dark ? `M${x} ${y}h1v1h-1z` : ''))).join('');
  return (
    <svg class="code" viewBox={`0 0 ${size} ${size}`} role="img" aria-label={t`Code with the address of this plan`} shape-rendering="crispEdges">
      <rect width={size} height={size} fill="#fff" />
      <path d={d} fill="#000" />
    </svg>
  );
}

export function OnThePhone({ plan }: { plan: PlanFull }) {
  const [addresses, setAddresses] = useState<string[] | null>(null);
  const first = addresses?.[0];
  return (
    <>
      <div class="row">
        <Button aria-expanded={addresses !== null} onClick={() => (addresses ? setAddresses(null) : void attempt(async () => setAddresses((await api.addresses()).addresses)))}>
          {addresses ? t`Hide the code` : t`Open it on the phone`}
        </Button>
      </div>
      {addresses !== null && (first === undefined ? (
        <p class="hint">{t`Only this computer can open the page now. Start it again with “tramline serve --host 0.0.0.0”, with phone and computer in the same network; then a code appears here.`}</p>
      ) : (
        <div class="code-box">
          <Code text={addressOf(first, plan)} />
          <p class="hint">{t`Point the camera of the phone at the code. Phone and computer have to be in the same network. Whoever has the address can use the page.`}</p>
        </div>
      ))}
    </>
  );
}
