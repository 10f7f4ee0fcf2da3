// The map's place on the page. The engine comes after the first paint.
import { useEffect, useRef, useState } from 'preact/hooks';
import { attempt, complain } from '../../actions/notices';
import { metres } from '../../format';
import { unitOf } from '../../measures';
import { farmBox } from '../../map/boxes';
import { engine, loadEngine } from '../../map/engine_loader';
import { firstPaint } from '../../map/first_paint';
import type { Scale } from '../../map/grid';
import { Icon } from '../../parts/icon';
import { fields } from '../../state/fields';
import { plans } from '../../state/plans';
import { review } from '../../state/review';
import { session, tilesHost } from '../../state/session';
import { useStore } from '../../state/store';
import { DrawingBar } from './drawing_bar';
import { t } from '../../words';

const webglWorks = () => document.createElement('canvas').getContext('webgl2') !== null;

async function drawMap(box: () => HTMLElement | null, scaled: (scale: Scale) => void): Promise<void> {
  await firstPaint();
  try {
    await loadEngine(box, scaled);
  } catch (error) {
    if (webglWorks()) throw error;
    complain(t`This browser cannot draw the map: it has no WebGL 2. Everything else works; use another browser to see the field.`);
  }
}

export function MapHost() {
  const box = useRef<HTMLDivElement>(null);
  const [scale, setScale] = useState<Scale | null>(null);
  useEffect(() => {
    void attempt(() => drawMap(() => box.current, setScale));
  }, []);
  const drawing = useStore(plans, (value) => value.drawing);
  return (
    <section class="map" aria-label={t`Map`} aria-busy={drawing}>
      <div ref={box} class="canvas" data-testid="map" />
      <div class="crosshair" aria-hidden="true" />
      <MapButtons />
      {scale && <ScaleBar {...scale} />}
      <Attribution />
      <DrawingBar />
    </section>
  );
}

/** Round lengths have no decimals that say nothing. */
function short(m: number): string {
  const { name, size } = unitOf('m');
  const round = Number((m / size).toPrecision(3));
  if (name === 'm' && m >= 1000) return `${m / 1000} km`;
  return round >= 1 ? `${round} ${name}` : metres(m);
}

const ScaleBar = ({ length_m, width_px, grid_m }: Scale) => (
  <div class="scale" role="img" aria-label={t`Scale: the bar is ${short(length_m)} long, and the lines of the grid are ${short(grid_m)} apart`}>
    <span class="bar" style={{ width: `${Math.round(width_px)}px` }} />
    <span>{short(length_m)}</span>
    <span class="grid-step">{t`grid ${short(grid_m)}`}</span>
  </div>
);

/** Whom the background is from. */
function Attribution() {
  const info = useStore(session, (value) => value.info);
  const on = useStore(session, (value) => value.tiles);
  if (!on || !info?.tiles) return null;
  return <p class="attribution">{info.tiles_attribution ?? t`Background: ${tilesHost()}`}</p>;
}

function MapButtons() {
  const tiles = useStore(session, (value) => value.info?.tiles ?? null);
  const tilesOn = useStore(session, (value) => value.tiles);
  const fitAll = () => {
    const view = session.get().view;
    const box = (view === 'review' ? review.get().drive?.bbox : null) ?? fields.get().open?.bbox ?? farmBox(fields.get().list ?? []);
    if (box) engine()?.fit(box);
  };
  return (
    <div class="map-buttons">
      <button type="button" class="button square" aria-label={t`Zoom in`} onClick={() => engine()?.zoomBy(1)}><Icon name="plus" /></button>
      <button type="button" class="button square" aria-label={t`Zoom out`} onClick={() => engine()?.zoomBy(-1)}><Icon name="minus" /></button>
      <button type="button" class="button square" aria-label={t`Show the whole field`} onClick={fitAll}><Icon name="fit" /></button>
      {tiles !== null && (
        <button type="button" class="button" aria-pressed={tilesOn} onClick={() => session.set({ tiles: !tilesOn })}>{t`Background`}</button>
      )}
    </div>
  );
}
