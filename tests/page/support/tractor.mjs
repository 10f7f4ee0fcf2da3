// A machine that drives a recorded log once more, over TCP.
import { createServer } from 'node:net';
import { readFileSync } from 'node:fs';

/** Listens on a free port; whoever connects gets the header, then `per_s` lines a second, at most `most` of them; then `allSent` is fulfilled. */
export function startTractor(log, { per_s = 200, most = Infinity } = {}) {
  const lines = readFileSync(log, 'utf8').trimEnd().split('\n');
  const header = lines.shift();
  const sockets = new Set();
  const last = Math.min(lines.length, most);
  let sent = 0;
  let tellAllSent;
  const allSent = new Promise((done) => { tellAllSent = done; });
  const server = createServer((socket) => {
    sockets.add(socket);
    socket.on('error', () => {});
    socket.write(`${header}\n`);
    const every = 50;
    const timer = setInterval(() => {
      const upTo = Math.min(sent + (per_s * every) / 1000, last);
      while (sent < upTo) socket.write(`${lines[sent++]}\n`);
      if (sent >= last) tellAllSent();
    }, every);
    socket.on('close', () => {
      clearInterval(timer);
      sockets.delete(socket);
    });
  });
  return new Promise((resolve) =>
    server.listen(0, '127.0.0.1', () =>
      resolve({
        port: server.address().port,
        allSent,
        hangUp: () => sockets.forEach((socket) => socket.destroy()),
        stop: () => {
          sockets.forEach((socket) => socket.destroy());
          return new Promise((done) => server.close(done));
        },
      }),
    ),
  );
}
