// What is on the map, each thing with its size, to switch on and off.
import { attempt } from '../../actions/notices';
import { switchLayer } from '../../actions/plans';
import type { LayerItem } from '../../api/types';
import { area, length } from '../../format';
import { DAY, NIGHT, type Colours } from '../../map/palette';
import { PARTS_OF } from '../../map/layers/plan_layers';
import { Switch } from '../../parts/switch';
import { isShown, plans } from '../../state/plans';
import { isNight, session } from '../../state/session';
import { useStore } from '../../state/store';
import { t } from '../../words';

type Mark = { colour: keyof Colours & string; form: 'area' | 'line' | 'dashed' };
const KNOWN: Record<string, { title: string; mark: Mark }> = {
  overlap: { title: t`Overlap`, mark: { colour: 'Overlap', form: 'area' } },
  outside: { title: t`Of it outside the field`, mark: { colour: 'NoRoom', form: 'dashed' } },
  uncovered: { title: t`Uncovered`, mark: { colour: 'Uncovered', form: 'area' } },
  headland_unworked: { title: t`Of it in the headland`, mark: { colour: 'Uncovered', form: 'area' } },
  tracks: { title: t`Tracks`, mark: { colour: 'Track', form: 'line' } },
  route_legs: { title: t`Route`, mark: { colour: 'Turn', form: 'line' } },
  swaths: { title: t`Swaths`, mark: { colour: 'Rule', form: 'area' } },
  detours: { title: t`Detours`, mark: { colour: 'Detour', form: 'line' } },
  headland_passes: { title: t`Headland passes`, mark: { colour: 'HeadlandPass', form: 'line' } },
  headland: { title: t`Headland`, mark: { colour: 'Headland', form: 'area' } },
  subfields: { title: t`Subfields`, mark: { colour: 'Passable', form: 'area' } },
  given_up: { title: t`Left out on purpose`, mark: { colour: 'Uncovered', form: 'area' } },
  worked: { title: t`Worked before`, mark: { colour: 'Covered', form: 'area' } },
  dropped: { title: t`Not worth driving`, mark: { colour: 'Dropped', form: 'dashed' } },
};

const size = (layer: LayerItem) => (layer.m !== null ? length(layer.m) : layer.m2 !== null ? area(layer.m2) : String(layer.features));

export function LayerList() {
  const layers = useStore(plans, (value) => value.layers);
  useStore(plans, (value) => value.shown);
  useStore(session, (value) => value.theme);
  const colours = isNight() ? NIGHT : DAY;
  const rows = Object.keys(KNOWN)
    .map((name) => layers.find((layer) => layer.name === name))
    .filter((layer): layer is LayerItem => layer !== undefined && layer.features > 0 && (layer.m2 === null || layer.m2 >= 0.05) && layer.name in PARTS_OF);
  return (
    <div class="layers">
      {rows.map((layer) => {
        const { title, mark } = KNOWN[layer.name]!;
        return (
          <Switch key={layer.name} on={isShown(layer.name)} label={title} value={size(layer)}
            mark={{ colour: String(colours[mark.colour]), form: mark.form }}
            change={(on) => void attempt(() => switchLayer(layer.name, on))} />
        );
      })}
    </div>
  );
}
