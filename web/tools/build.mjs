// Bundles the page. The same sources give the same bytes.
// Usage: build.mjs --out FOLDER [--table FILE.cpp]
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';
import { writeTable } from './table.mjs';

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const { values } = parseArgs({ options: { out: { type: 'string' }, table: { type: 'string' } } });
if (!values.out) throw new Error('build.mjs: say where to with --out');
const out = resolve(values.out);
const maplibre = join(web, 'node_modules', 'maplibre-gl', 'dist');

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });

const result = await build({
  absWorkingDir: web,
  entryPoints: { app: 'src/main.tsx', style: 'src/style/page.css' },
  outdir: out,
  bundle: true,
  splitting: true,
  format: 'esm',
  target: ['es2022'],
  minify: true,
  metafile: true,
  entryNames: '[name]-[hash]',
  chunkNames: '[name]-[hash]',
  jsx: 'automatic',
  jsxImportSource: 'preact',
  legalComments: 'none',
  // The build of MapLibre that takes its worker from a file, as the page's policy asks for.
  alias: { 'maplibre-gl': join(maplibre, 'maplibre-gl-csp.js') },
  logLevel: 'warning',
});

// What is run before the first paint needs nothing else.
const frame = await build({
  absWorkingDir: web, entryPoints: { frame: 'src/frame.ts' }, outdir: out, bundle: true, format: 'iife', target: ['es2022'], minify: true,
  metafile: true, entryNames: '[name]-[hash]', legalComments: 'none', logLevel: 'warning',
});

const named = (entry) => {
  const found = Object.entries(result.metafile.outputs).find(([, output]) => output.entryPoint === entry);
  return found[0].split('/').pop();
};
/** What an output needs at once, itself among it. */
function needed(output, all = new Set()) {
  if (all.has(output)) return all;
  all.add(output);
  for (const { path, kind } of result.metafile.outputs[output].imports) if (kind === 'import-statement') needed(path, all);
  return all;
}
copyFileSync(join(maplibre, 'maplibre-gl-csp-worker.js'), join(out, 'map-worker.js'));
for (const file of readdirSync(join(web, 'public'))) {
  if (file !== 'index.html') copyFileSync(join(web, 'public', file), join(out, file));
}
// The example farm of an empty store: fields drawn for the project, in one file.
const EXAMPLES = ['riverside', 'roadside'];
const farm = EXAMPLES.flatMap((name) =>
  JSON.parse(readFileSync(join(web, '..', 'examples', `${name}.geojson`), 'utf8')).features.map((feature) => ({
    ...feature, properties: { ...feature.properties, name: feature.properties.name ?? `${name[0].toUpperCase()}${name.slice(1)}` },
  })));
writeFileSync(join(out, 'example-farm.json'), JSON.stringify({ type: 'FeatureCollection', features: farm }));
// Asked for together: found out one after the other they take a journey to the server each.
const app = Object.entries(result.metafile.outputs).find(([, output]) => output.entryPoint === 'src/main.tsx')[0];
const ahead = [...needed(app)].map((output) => `<link rel="modulepreload" href="${output.split('/').pop()}">\n`).sort().join('');
const index = readFileSync(join(web, 'public', 'index.html'), 'utf8')
  .replace('frame.js', Object.keys(frame.metafile.outputs)[0].split('/').pop())
  .replace('app.js', named('src/main.tsx'))
  .replace('style.css', named('src/style/page.css'))
  .replace('</head>', `${ahead}</head>`);
writeFileSync(join(out, 'index.html'), index);

if (values.table) writeTable(out, resolve(values.table));
