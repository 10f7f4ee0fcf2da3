// Server-sent events, as callbacks by name.
export interface Stream {
  close(): void;
}

export function openStream(address: string, on: Record<string, (data: never) => void>, lost: () => void): Stream {
  const source = new EventSource(address);
  for (const [name, handle] of Object.entries(on)) {
    source.addEventListener(name, (event) => handle(JSON.parse((event as MessageEvent<string>).data) as never));
  }
  source.addEventListener('error', (event) => {
    // An event of the server that is called "error" has data, a broken connection has none.
    if ('data' in event) return;
    source.close();
    lost();
  });
  return { close: () => source.close() };
}
