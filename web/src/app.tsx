import { setTheme, show } from './actions/session';
import { Icon, type IconName } from './parts/icon';
import { measures } from './measures';
import { fields } from './state/fields';
import { isNight, session, type View } from './state/session';
import { useStore } from './state/store';
import { CompareView } from './views/compare/compare_view';
import { FieldsView } from './views/fields/fields_view';
import { Locked } from './views/locked';
import { Legend } from './views/map/legend';
import { MapHost } from './views/map/map_host';
import { Settings } from './views/settings';
import { Notices } from './views/notices';
import { Tour } from './views/tour';
import { PlanView } from './views/plan/plan_view';
import { ReviewView } from './views/review/review_view';
import { t } from './words';

const VIEWS: { view: View; title: string; icon: IconName }[] = [
  { view: 'fields', title: t`Fields`, icon: 'field' },
  { view: 'plan', title: t`Plan`, icon: 'plan' },
  { view: 'compare', title: t`Compare`, icon: 'compare' },
  { view: 'review', title: t`Review`, icon: 'review' },
];

export function App() {
  const locked = useStore(session, (value) => value.locked);
  const settings = useStore(session, (value) => value.settings);
  useStore(measures, (value) => value); // what is written follows the units
  return (
    <div class="page">
      <a class="skip" href="#panel" onClick={(event) => { event.preventDefault(); document.getElementById('panel')?.focus(); }}>{t`Skip to the panel`}</a>
      <Header />
      <Tabs />
      <main class="panel" id="panel" tabIndex={-1}>
        <Notices />
        {settings && <Settings />}
        {!locked && <Tour />}
        {locked ? <Locked /> : <View />}
      </main>
      {!locked && <MapHost />}
      {!locked && <Legend />}
    </div>
  );
}

function Header() {
  const field = useStore(fields, (value) => value.open?.name);
  useStore(session, (value) => value.theme);
  const open = useStore(session, (value) => value.settings);
  const night = isNight();
  return (
    <header>
      <h1>
        <svg class="logo" viewBox="0 0 24 24" aria-hidden="true"><path d="M7 22C7 14 9 8 17 2M13 22C13 15 15 10 22 5M1 22C1 12 4 5 11 0" fill="none" stroke="currentColor" stroke-width="2.2" stroke-linecap="round" /></svg>
        tramline
      </h1>
      <span class="which">{field ?? ''}</span>
      <button type="button" class="button quiet square" aria-label={t`Language and units`} aria-expanded={open} onClick={() => session.set({ settings: !open })}>
        <Icon name="settings" />
      </button>
      <button type="button" class="button quiet square" aria-label={night ? t`Change to the day theme` : t`Change to the night theme`} onClick={() => setTheme(night ? 'day' : 'night')}>
        <Icon name={night ? 'sun' : 'moon'} />
      </button>
    </header>
  );
}

function Tabs() {
  const view = useStore(session, (value) => value.view);
  return (
    <nav aria-label={t`Views`}>
      {VIEWS.map((one) => (
        <button key={one.view} type="button" aria-current={one.view === view ? 'page' : undefined} onClick={() => show(one.view)}>
          <Icon name={one.icon} />
          <span>{one.title}</span>
        </button>
      ))}
    </nav>
  );
}

function View() {
  const view = useStore(session, (value) => value.view);
  switch (view) {
    case 'fields': return <FieldsView />;
    case 'plan': return <PlanView />;
    case 'compare': return <CompareView />;
    case 'review': return <ReviewView />;
  }
}
