// Every file that can be made of a plan.
import { useState } from 'preact/hooks';
import { attempt } from '../../actions/notices';
import { keepPlan } from '../../actions/plans';
import { planFile } from '../../api/addresses';
import type { PlanFull } from '../../api/types';
import { Expander } from '../../parts/expander';
import { Icon } from '../../parts/icon';
import { t } from '../../words';

const FILES: { format: string; name: string; what: string; crs: boolean }[] = [
  { format: 'gpkg', name: 'GeoPackage', what: t`everything, for QGIS and for tramline`, crs: false },
  { format: 'geojson', name: 'GeoJSON', what: t`the tracks`, crs: false },
  { format: 'kml', name: 'KML', what: t`the tracks, for Google Earth`, crs: false },
  { format: 'shapefile', name: t`Shapefiles`, what: t`all layers, zipped, for terminals`, crs: true },
  { format: 'flatgeobuf', name: 'FlatGeobuf', what: t`the tracks`, crs: true },
  { format: 'png', name: t`Picture`, what: 'PNG', crs: false },
  { format: 'svg', name: t`Drawing`, what: 'SVG', crs: false },
  { format: 'pdf', name: t`Sheet`, what: t`PDF, to print`, crs: false },
];

export function PlanFiles({ plan }: { plan: PlanFull }) {
  const [crs, setCrs] = useState('');
  return (
    <section aria-labelledby="take-title">
      <h2 id="take-title">{t`Download`}</h2>
      <ul class="files">
        {FILES.map(({ format, name, what, crs: takes }) => (
          <li key={format}>
            <a class="file" href={planFile(plan.id, format, takes && crs ? { crs } : {})} download
              onClick={() => plan.draft && void attempt(() => keepPlan(plan.id))}>
              <Icon name="down" />
              <span class="grow"><strong>{name}</strong><span class="sub">{what}</span></span>
            </a>
          </li>
        ))}
      </ul>
      <Expander title={t`Another coordinate system`}>
        <label class="field">
          <span class="label">{t`For Shapefiles and FlatGeobuf`}</span>
          <input type="text" placeholder="EPSG:25832" value={crs} onInput={(event) => setCrs(event.currentTarget.value.trim())} />
        </label>
        <p class="hint">{t`If left empty: the coordinate system of the field’s own file.`}</p>
      </Expander>
    </section>
  );
}
