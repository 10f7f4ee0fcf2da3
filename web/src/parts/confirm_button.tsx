import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Button } from './button';

/** A button that has to be pressed twice. */
export function ConfirmButton({ label, ask, children, act }: { label: string; ask: string; children: ComponentChildren; act: () => void }) {
  const [asked, setAsked] = useState(false);
  useEffect(() => {
    if (!asked) return;
    const timer = setTimeout(() => setAsked(false), 6000);
    return () => clearTimeout(timer);
  }, [asked]);
  return asked ? (
    <Button kind="danger" onClick={act} onBlur={() => setAsked(false)}>{ask}</Button>
  ) : (
    <Button kind="quiet" aria-label={label} onClick={() => setAsked(true)}>{children}</Button>
  );
}
