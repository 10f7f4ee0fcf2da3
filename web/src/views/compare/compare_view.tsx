import { fields } from '../../state/fields';
import { plans } from '../../state/plans';
import { useStore } from '../../state/store';
import { NoField } from '../no_field';
import { Reasons } from './reasons';
import { SideBySide } from './side_by_side';
import { TradeOff } from './trade_off';

export function CompareView() {
  const field = useStore(fields, (value) => value.open);
  const open = useStore(plans, (value) => value.open);
  if (!field) return <NoField />;
  return (
    <>
      <TradeOff field={field.id} />
      <SideBySide />
      {open && <Reasons plan={open} />}
    </>
  );
}
