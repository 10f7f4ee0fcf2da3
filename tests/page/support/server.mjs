// A tramline server of its own for each test: a free port, a temporary folder.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../../..', import.meta.url));
export const tramline = process.env.TRAMLINE ?? join(root, 'build/release/apps/tramline/tramline');
export const example = (name) => join(root, 'examples', name);

export function freePort() {
  return new Promise((resolve, reject) => {
    const probe = createServer();
    probe.once('error', reject);
    probe.listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });
}

async function answers(address, child) {
  for (let i = 0; i < 200; i++) {
    if (child.exitCode !== null) throw new Error(`tramline serve ended with ${child.exitCode}`);
    try {
      await fetch(address);
      return;
    } catch {
      await new Promise((wake) => setTimeout(wake, 50));
    }
  }
  throw new Error('tramline serve did not answer within 10 s');
}

function launch(server) {
  const child = spawn(tramline, ['serve', server.folder, '--port', String(server.port), ...server.args], {
    stdio: ['ignore', 'pipe', 'pipe'],
    env: { ...process.env, HOME: server.folder },
  });
  server.printed = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => (server.printed += data));
  server.child = child;
  return answers(server.address, child);
}

/** {address, folder, printed, stop(), kill(), again()}: `again` starts it anew on the same port and folder. */
export async function startServer({ args = [] } = {}) {
  const server = { args, folder: mkdtempSync(join(tmpdir(), 'tramline-page-')), port: await freePort() };
  server.address = `http://127.0.0.1:${server.port}`;
  const ended = () => (server.child.exitCode !== null || server.child.signalCode !== null ? Promise.resolve() : new Promise((done) => server.child.once('exit', done)));
  server.kill = async () => {
    server.child.kill('SIGKILL');
    await ended();
  };
  server.again = () => launch(server);
  server.stop = async () => {
    server.child.kill('SIGTERM');
    const timer = setTimeout(() => server.child.kill('SIGKILL'), 5000);
    await ended();
    clearTimeout(timer);
    rmSync(server.folder, { recursive: true, force: true });
  };
  try {
    await launch(server);
  } catch (error) {
    error.message += `\n${server.printed}`;
    await server.stop();
    throw error;
  }
  return server;
}
