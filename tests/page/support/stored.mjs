// What a server keeps, and fields so small that the whole job on them is planned in a second.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

export const ask = async (server, path) => (await fetch(`${server.address}/api/v1${path}`)).json();
export const openId = (page, what) => new URLSearchParams(new URL(page.url()).hash.slice(1)).get(what);

// Corners in degrees from (9° E, 50° N): about 70 m to 0.001° of longitude, 111 m of latitude.
const SHAPES = {
  slant: [[0, 0], [0.0021, 0], [0.0018, 0.0009], [0.0002, 0.0011]],
  angle: [[0, 0], [0.004, 0], [0.004, 0.0006], [0.001, 0.0007], [0.0009, 0.0031], [0.0001, 0.003]],
};

export const polygonOf = (shape, west = 9, south = 50) => {
  const ring = SHAPES[shape].map(([x, y]) => [west + x, south + y]);
  return { type: 'Polygon', coordinates: [[...ring, ring[0]]] };
};

/** A file with one field: a slanting quadrangle of 1.6 ha, or an angle of two arms. */
export function smallField(folder, shape = 'slant') {
  const file = join(folder, `${shape}.geojson`);
  writeFileSync(file, JSON.stringify({ type: 'FeatureCollection', features: [{ type: 'Feature', properties: { name: `${shape} field` }, geometry: polygonOf(shape) }] }));
  return file;
}

const send = async (server, path, body, type = 'application/json') => {
  const answer = await fetch(`${server.address}/api/v1${path}`, { method: 'POST', headers: { 'Content-Type': type }, body: typeof body === 'string' ? body : JSON.stringify(body) });
  const json = await answer.json();
  if (!answer.ok) throw new Error(`${path}: ${json.error?.message ?? answer.status}`);
  return json;
};

/** Stores a field of a GeoJSON feature, without the page; its id. */
export async function storeField(server, feature) {
  const upload = await send(server, '/uploads?name=field.geojson', JSON.stringify({ type: 'FeatureCollection', features: [feature] }), 'application/geo+json');
  // By the name that the page gives it.
  return (await send(server, '/fields', { upload: upload.id, name: feature.properties.name })).id;
}

/** Plans the whole job on a stored field, without the page, and searches for so many seconds at the most; its id. */
export async function storePlan(server, field, seconds, machine = { width_m: 6, radius_m: 6 }) {
  let job = await send(server, '/jobs', { kind: 'plan', field, machine, seconds });
  while (job.state === 'queued' || job.state === 'running') {
    await new Promise((wake) => setTimeout(wake, 100));
    job = await ask(server, `/jobs/${job.id}`);
  }
  if (job.state !== 'done') throw new Error(`${field}: ${JSON.stringify(job.error)}`);
  return job.result.plan;
}
