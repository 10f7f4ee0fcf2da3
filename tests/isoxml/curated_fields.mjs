// Task sets of all curated real fields, one field and four hundred a set, in both versions, read by the npm package isoxml: no
// warnings, and the boundaries and holes of fields that were not repaired as their own file has them. CHECK (task_set_check) finds
// each set as the standard has it, and as our own reader reads it.
// Usage: curated_fields.mjs FIELDS.geojson   (TRAMLINE and CHECK name the programs)
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { readTaskSet, ringDifference } from './task_set.mjs';

const IN_A_LARGE_SET = 400;
const [source] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'tramline-curated-'));
const run = (...args) => execFileSync(process.env.TRAMLINE, args, { encoding: 'utf8', maxBuffer: 1 << 30 });

const outlines = new Map(JSON.parse(readFileSync(source, 'utf8')).features.map((feature) => [feature.properties.id, feature.geometry.coordinates]));
let faults = 0, compared = 0, fields = 0;
const fault = (where, what) => {
  faults++;
  console.log(`${where}: ${what}`);
};

function compareOutline(where, field, id, untouched) {
  const wanted = outlines.get(id);
  if (!wanted) return fault(where, `there is no field ${id}`);
  if (!untouched.has(id)) return;
  compared++;
  const [rings] = field.boundaries;
  if (rings.length !== wanted.length) return fault(where, `${field.name} has ${rings.length} rings instead of ${wanted.length}`);
  // Obstacles keep the order of the holes.
  rings.forEach((ring, i) => {
    const what = ringDifference(ring, wanted[i]);
    if (what) fault(where, `${field.name}, ring ${i + 1}: ${what}`);
  });
}

async function examine(plans, version, untouched) {
  const target = join(folder, 'set.zip');
  rmSync(target, { force: true });
  const report = JSON.parse(run('export', ...plans, '-o', target, '--isoxml', version, '--lines', 'all', '--json'));
  const where = `version ${version}, ${plans.length} plans`;
  const check = spawnSync(process.env.CHECK, [target], { encoding: 'utf8' });
  if (check.status !== 0) fault(where, check.stdout);
  const set = await readTaskSet(target);
  set.warnings.forEach((warning) => fault(where, warning));
  if (set.fields.length !== plans.length) fault(where, `${set.fields.length} fields`);
  if (set.fields.flatMap((field) => field.lines).length !== report.lines) fault(where, 'lines are missing');
  const ids = new Map(report.renamed.map(({ name, shown }) => [shown, name]));
  set.fields.forEach((field) => compareOutline(where, field, ids.get(field.name) ?? field.name, untouched));
  fields += set.fields.length;
  return { bytes: report.bytes, zipped: statSync(target).size };
}

const results = run('plan', source, '--all', '--width', '6', '--headlands', '1', '--strategy', 'sweep', '--json', '-o', join(folder, 'plan.gpkg'))
  .trim().split('\n').map((line) => JSON.parse(line)).filter((result) => result.field_id);
const untouched = new Set(results.filter((result) => result.repairs.length === 0).map((result) => result.field_id));
const plans = readdirSync(folder).filter((name) => name.endsWith('.gpkg')).sort().map((name) => join(folder, name));
const many = Array.from({ length: IN_A_LARGE_SET }, (_, i) => plans[i % plans.length]);
for (const version of ['4', '3']) {
  for (const plan of plans) await examine([plan], version, untouched);
  const { bytes, zipped } = await examine(many, version, untouched);
  console.log(`version ${version}: ${IN_A_LARGE_SET} fields, ${(bytes / 1e6).toFixed(1)} MB, ${(zipped / 1e6).toFixed(1)} MB zipped`);
}
rmSync(folder, { recursive: true, force: true });
console.log(`${plans.length} plans, ${fields} fields read, ${compared} outlines compared, ${faults} faults`);
process.exit(faults === 0 && compared > 0 ? 0 : 1);
