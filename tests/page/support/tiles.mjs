// A server of raster tiles: each a PNG in one colour with a darker rim, made here.
import { createServer } from 'node:http';
import { deflateSync } from 'node:zlib';

const SIZE = 256;

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

function chunk(type, data) {
  const out = Buffer.alloc(12 + data.length);
  out.writeUInt32BE(data.length, 0);
  out.write(type, 4, 'latin1');
  data.copy(out, 8);
  out.writeUInt32BE(crc32(out.subarray(4, 8 + data.length)), 8 + data.length);
  return out;
}

/** Tiles next to one another differ, as squares of a chess board do. */
function tile(x, y) {
  const [r, g, b] = (x + y) % 2 === 0 ? [150, 190, 120] : [190, 175, 120];
  const rows = Buffer.alloc(SIZE * (1 + 3 * SIZE));
  for (let row = 0; row < SIZE; row++) {
    for (let column = 0; column < SIZE; column++) {
      const rim = row < 2 || column < 2;
      const at = row * (1 + 3 * SIZE) + 1 + 3 * column;
      rows[at] = rim ? r - 60 : r;
      rows[at + 1] = rim ? g - 60 : g;
      rows[at + 2] = rim ? b - 60 : b;
    }
  }
  const header = Buffer.from([0, 0, 1, 0, 0, 0, 1, 0, 8, 2, 0, 0, 0]);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk('IHDR', header), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** {url, origin, asked(): tiles asked for so far, fail(on): from now on every answer is a failure, stop()} */
export async function startTiles() {
  let asked = 0;
  let failing = false;
  const server = createServer((request, response) => {
    const place = /^\/(\d+)\/(\d+)\/(\d+)\.png$/.exec(request.url);
    asked++;
    if (!place || failing) {
      response.writeHead(500, { 'Access-Control-Allow-Origin': '*' });
      response.end();
      return;
    }
    response.writeHead(200, { 'Content-Type': 'image/png', 'Access-Control-Allow-Origin': '*', 'Cache-Control': 'no-store' });
    response.end(tile(Number(place[2]), Number(place[3])));
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  const origin = `http://127.0.0.1:${server.address().port}`;
  return {
    origin,
    url: `${origin}/{z}/{x}/{y}.png`,
    asked: () => asked,
    fail: (on) => (failing = on),
    stop: () => new Promise((done) => { server.closeAllConnections(); server.close(done); }),
  };
}
