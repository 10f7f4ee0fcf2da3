// A value that tells its listeners when it changes, and a hook that draws a component anew when the part of
// it that the component looks at changes.
import { useEffect, useReducer, useRef } from 'preact/hooks';

export interface Store<T extends object> {
  get(): T;
  set(change: Partial<T>): void;
  /** Returns how to stop listening. */
  listen(heard: () => void): () => void;
}

export function store<T extends object>(initial: T): Store<T> {
  let value = initial;
  const listeners = new Set<() => void>();
  return {
    get: () => value,
    set(change) {
      const keys = Object.keys(change) as (keyof T)[];
      if (keys.every((key) => Object.is(value[key], change[key]))) return;
      value = { ...value, ...change };
      for (const heard of [...listeners]) heard();
    },
    listen(heard) {
      listeners.add(heard);
      return () => listeners.delete(heard);
    },
  };
}

export function useStore<T extends object, S>(from: Store<T>, pick: (value: T) => S): S {
  const [, redraw] = useReducer((n: number) => n + 1, 0);
  const picked = pick(from.get());
  const last = useRef(picked);
  last.current = picked;
  const picker = useRef(pick);
  picker.current = pick;
  useEffect(() => {
    const heard = () => {
      if (!Object.is(picker.current(from.get()), last.current)) redraw(0);
    };
    heard(); // what changed between drawing and listening
    return from.listen(heard);
  }, [from]);
  return picked;
}
