// The page's colours are those of the library's pictures.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './support/server.mjs';

const header = readFileSync(join(root, 'src/tramline/model/palette.h'), 'utf8');
const page = readFileSync(join(root, 'web/src/map/palette.ts'), 'utf8');

/** Hex constants and colours of the header: kOverlapHex and kOverlapColour are both "Overlap". */
function coloursOfLibrary() {
  const colours = new Map();
  const plain = (name) => name.replace(/(Hex|Colour)$/, '');
  for (const [, name, hex] of header.matchAll(/constexpr std::uint32_t k(\w+) = 0x([0-9A-F]{6});/g)) colours.set(plain(name), hex);
  for (const [, name, hex] of header.matchAll(/constexpr Colour k(\w+) = rgb\(0x([0-9A-F]{6})/g)) colours.set(plain(name), hex);
  return colours;
}

test('every colour by day is one of palette.h', () => {
  const library = coloursOfLibrary();
  const block = /export const PICTURE = \{([^}]*)\}/.exec(page)[1];
  const named = [...block.matchAll(/(\w+): '#([0-9A-F]{6})'/g)];
  assert.ok(named.length >= 20, `${named.length} colours`);
  for (const [, name, hex] of named) assert.equal(hex, library.get(name), name);
});

test('the tints of subfields are those of palette.h, in its order', () => {
  const tints = (text) => [...text.matchAll(/[#x]([0-9A-F]{6})/g)].map(([, hex]) => hex);
  const ours = tints(/export const TINTS = \[([^\]]*)\]/.exec(page)[1]);
  const theirs = tints(/kTints = \{([^}]*)\}/.exec(header)[1]);
  assert.deepEqual(ours, theirs);
  assert.equal(ours.length, 8);
});
