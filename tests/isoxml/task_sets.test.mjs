// Task sets of the example fields, read by the npm package isoxml: no warnings, and every coordinate as GeoJSON has it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { difference, readTaskSet, ringDifference } from './task_set.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const tramline = process.env.TRAMLINE ?? join(root, 'build/release/apps/tramline/tramline');
const folder = mkdtempSync(join(tmpdir(), 'tramline-isoxml-'));
const at = (name) => join(folder, name);
const run = (...args) => execFileSync(tramline, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
const layer = (plan, name) => {
  run('export', plan, '-o', at('layer.geojson'), '--layer', name, '--tolerance', '0', '--quiet');
  return JSON.parse(readFileSync(at('layer.geojson'), 'utf8')).features;
};

before(() => {
  run('plan', join(root, 'examples/riverside.geojson'), '--width', '12', '--headlands', '1', '--obstacles',
    join(root, 'examples/riverside-obstacles.geojson'), '--prices', '0.02,0.10,1,5,5', '--quiet', '-o', at('plan.gpkg'));
  run('plan', join(root, 'examples/two-farms.gpkg'), '--layer', 'parcels', '--all', '--width', '12', '--prices', '0.02,0.10,1,5,5',
    '--quiet', '--one-file', '-o', at('farms.gpkg'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

for (const version of ['4', '3'])
  for (const style of ['holes', 'polygons'])
    test(`version ${version} with obstacles as ${style}`, async () => {
      const target = at(`set-${version}-${style}.zip`);
      run('export', at('plan.gpkg'), '-o', target, '--isoxml', version, '--isoxml-obstacles', style, '--lines', 'all', '--tolerance', '0', '--quiet');
      const { warnings, fields, tasks } = await readTaskSet(target);
      assert.deepEqual(warnings, []);
      assert.equal(fields.length, 1);
      assert.deepEqual(tasks, [fields[0].name]);
      const [field] = fields;

      const [outline] = layer(at('plan.gpkg'), 'field');
      const obstacles = layer(at('plan.gpkg'), 'obstacles').map((feature) => feature.geometry.coordinates[0]);
      const told = style === 'holes' ? field.boundaries[0].slice(1) : field.obstacles.map(([ring]) => ring);
      assert.equal(ringDifference(field.boundaries[0][0], outline.geometry.coordinates[0]), '');
      assert.ok(obstacles.length > 2);
      assert.equal(told.length, obstacles.length);
      told.forEach((ring, i) => assert.equal(ringDifference(ring, obstacles[i]), ''));
      assert.ok(field.headlands.length > 0);

      const driven = [...layer(at('plan.gpkg'), 'tracks'), ...layer(at('plan.gpkg'), 'headland_passes')];
      assert.ok(driven.length > 10);
      assert.equal(field.lines.length, driven.length);
      field.lines.forEach(({ name, points }, i) => assert.equal(difference(points, driven[i].geometry.coordinates), '', name));
    });

test('many fields in one set, a line for each subfield', async () => {
  for (const version of ['4', '3']) {
    const report = JSON.parse(run('export', at('plan.gpkg'), at('farms.gpkg'), '-o', at('all.zip'), '--isoxml', version, '--json'));
    const { warnings, fields, tasks } = await readTaskSet(at('all.zip'));
    assert.deepEqual(warnings, []);
    assert.ok(fields.length > 3);
    assert.equal(fields.length, report.fields);
    assert.equal(tasks.length, fields.length);
    assert.equal(new Set(fields.map((field) => field.name)).size, fields.length);
    assert.equal(fields.flatMap((field) => field.lines).length, report.lines);
  }
});
