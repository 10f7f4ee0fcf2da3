import { drawFor } from '../../actions/drawing';
import { storeDrawnField, takeFieldFile } from '../../actions/fields';
import { attempt } from '../../actions/notices';
import { Button } from '../../parts/button';
import { DropZone } from '../../parts/drop_zone';
import { fields } from '../../state/fields';
import { useStore } from '../../state/store';
import { FeatureChooser } from './feature_chooser';
import { FieldList } from './field_list';
import { OpenField } from './open_field';
import { t } from '../../words';

export function FieldsView() {
  const busy = useStore(fields, (value) => value.busy);
  const choosing = useStore(fields, (value) => value.choosing);
  const open = useStore(fields, (value) => value.open);
  if (choosing) return <FeatureChooser upload={choosing} />;
  return (
    <>
      <section aria-label={t`Bring a field`}>
        <DropZone
          label={t`Choose a file with a field`}
          hint={t`or drop it here: GeoJSON, GeoPackage, KML, ISOXML, Shapefile (its .shp, .shx, .dbf and .prj together, or zipped)`}
          busy={busy}
          take={(files) => void attempt(() => takeFieldFile(files))}
        />
        <div class="row">
          <Button onClick={() => drawFor('field', (geometry) => storeDrawnField(t`Drawn field`, geometry))}>{t`Draw a field`}</Button>
        </div>
      </section>
      {open && <OpenField field={open} />}
      <FieldList />
    </>
  );
}
