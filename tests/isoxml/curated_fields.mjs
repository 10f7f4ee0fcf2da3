// Task sets of all curated real fields, one field and four hundred a set, in both versions, read by the npm package isoxml: no
// warnings, the boundaries and holes of fields that were not repaired as their own file has them, and every point of every guidance
// line as OGR has it. TASK_SET_CHECK finds each set as the standard has it, and as our own reader reads it. Field folders of
// AgOpenGPS are read by FOLDER_CHECK.
// Usage: curated_fields.mjs FIELDS.geojson   (TRAMLINE, TASK_SET_CHECK and FOLDER_CHECK name the programs)
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { difference, readTaskSet, ringDifference } from './task_set.mjs';

const IN_A_LARGE_SET = Number(process.env.IN_A_LARGE_SET ?? 400);
const [source] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'tramline-curated-'));
const run = (...args) => execFileSync(process.env.TRAMLINE, args, { encoding: 'utf8', maxBuffer: 1 << 30 });

const outlines = new Map(JSON.parse(readFileSync(source, 'utf8')).features.map((feature) => [feature.properties.id, feature.geometry.coordinates]));
let faults = 0, compared = 0, fields = 0, lines = 0, points = 0;
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

/** Features of a layer of a plan file, as OGR has them in degrees: every vertex, and none between them. */
function layerOf(plan, name) {
  const target = join(folder, 'layer.geojson');
  rmSync(target, { force: true });
  execFileSync('ogr2ogr', ['-f', 'GeoJSON', '-t_srs', 'EPSG:4326', '-lco', 'COORDINATE_PRECISION=12', target, plan, name]);
  return JSON.parse(readFileSync(target, 'utf8')).features;
}

/** What is driven, by the id of the field: tracks in their order, then headland passes. */
const driven = new Map();

const ends = (line) => [line[0], line.at(-1)];

/** Every point of every line; of a set of many fields, which would be too large with all points, their ends. */
function compareLines(where, field, id, thinned) {
  const wanted = driven.get(id);
  if (field.lines.length !== wanted.length) return fault(where, `${field.name} has ${field.lines.length} lines instead of ${wanted.length}`);
  field.lines.forEach((line, i) => {
    const what = thinned ? difference(ends(line.points), ends(wanted[i])) : difference(line.points, wanted[i]);
    if (what) fault(where, `${field.name}, ${line.name}: ${what}`);
    points += line.points.length;
  });
  lines += field.lines.length;
}

async function examine(plans, version, untouched) {
  const target = join(folder, 'set.zip');
  rmSync(target, { force: true });
  const thinned = plans.length > 1;
  const tolerance = thinned ? [] : ['--tolerance', '0'];
  const report = JSON.parse(run('export', ...plans, '-o', target, '--isoxml', version, '--lines', 'all', ...tolerance, '--json'));
  const where = `version ${version}, ${plans.length} plans`;
  const check = spawnSync(process.env.TASK_SET_CHECK, [target], { encoding: 'utf8' });
  if (check.status !== 0) fault(where, check.stdout);
  const set = await readTaskSet(target);
  set.warnings.forEach((warning) => fault(where, warning));
  if (set.fields.length !== plans.length) fault(where, `${set.fields.length} fields`);
  if (set.fields.flatMap((field) => field.lines).length !== report.lines) fault(where, 'lines are missing');
  const ids = new Map(report.renamed.map(({ name, shown }) => [shown, name]));
  set.fields.forEach((field) => {
    const id = ids.get(field.name) ?? field.name;
    compareOutline(where, field, id, untouched);
    compareLines(where, field, id, thinned);
  });
  fields += set.fields.length;
  return { bytes: report.bytes, zipped: statSync(target).size };
}

const results = run('plan', source, '--all', '--width', '6', '--headlands', '1', '--strategy', 'sweep', '--json', '-o', join(folder, 'plan.gpkg'))
  .trim().split('\n').map((line) => JSON.parse(line)).filter((result) => result.field_id);
const untouched = new Set(results.filter((result) => result.repairs.length === 0).map((result) => result.field_id));
const plans = readdirSync(folder).filter((name) => name.endsWith('.gpkg')).sort().map((name) => join(folder, name));
for (const plan of plans) {
  const ofPlan = [...layerOf(plan, 'tracks'), ...layerOf(plan, 'headland_passes')].map((feature) => feature.geometry.coordinates);
  driven.set(layerOf(plan, 'field')[0].properties.field_id, ofPlan);
}
const many = Array.from({ length: IN_A_LARGE_SET }, (_, i) => plans[i % plans.length]);
for (const version of ['4', '3']) {
  for (const plan of plans) await examine([plan], version, untouched);
  const { bytes, zipped } = await examine(many, version, untouched);
  console.log(`version ${version}: ${IN_A_LARGE_SET} fields, ${(bytes / 1e6).toFixed(1)} MB, ${(zipped / 1e6).toFixed(1)} MB zipped`);
}
// Folders of AgOpenGPS, with a curve or an AB line for each track.
plans.forEach((plan, i) => run('export', plan, '-o', join(folder, `Field ${i}`), '--agopengps', '--lines', 'all', '--quiet'));
const folders = spawnSync(process.env.FOLDER_CHECK, plans.flatMap((plan, i) => [join(folder, `Field ${i}`), plan]), { encoding: 'utf8', maxBuffer: 1 << 28 });
console.log(folders.stdout.trim());
if (folders.status !== 0) fault('AgOpenGPS', 'folders are not those of their plans');
rmSync(folder, { recursive: true, force: true });
console.log(`${plans.length} plans, ${fields} fields read, ${compared} outlines and ${lines} lines with ${points} points compared, ${faults} faults`);
process.exit(faults === 0 && compared > 0 && lines > 0 ? 0 : 1);
