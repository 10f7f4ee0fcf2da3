// Numbers and marks on the map, drawn on a canvas when the map first asks for them: text needs no glyph
// server, and collides like any other icon.
import type { Map as GlMap } from 'maplibre-gl';
import type { Colours } from './palette';

const RATIO = 2;
const FONT = '600 12px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';

function canvas(width: number, height: number): CanvasRenderingContext2D {
  const element = document.createElement('canvas');
  element.width = Math.ceil(width * RATIO);
  element.height = Math.ceil(height * RATIO);
  const context = element.getContext('2d', { willReadFrequently: true })!;
  context.scale(RATIO, RATIO);
  return context;
}
const pixels = (context: CanvasRenderingContext2D) =>
  context.getImageData(0, 0, context.canvas.width, context.canvas.height);

const measure = document.createElement('canvas').getContext('2d')!;

function pill(text: string, paper: string, ink: string, edge: string): ImageData {
  measure.font = FONT;
  const w = Math.max(18, Math.ceil(measure.measureText(text).width) + 8);
  const h = 18;
  const context = canvas(w, h);
  context.beginPath();
  context.roundRect(0.75, 0.75, w - 1.5, h - 1.5, 5);
  context.fillStyle = paper;
  context.fill();
  context.strokeStyle = edge;
  context.lineWidth = 1;
  context.stroke();
  context.font = FONT;
  context.fillStyle = ink;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(text, w / 2, h / 2 + 0.5);
  return pixels(context);
}

function arrow(colour: string, rim: string): ImageData {
  const context = canvas(14, 14);
  context.lineJoin = 'round';
  context.beginPath();
  context.moveTo(3, 2.5);
  context.lineTo(11.5, 7);
  context.lineTo(3, 11.5);
  context.lineTo(5, 7);
  context.closePath();
  context.strokeStyle = rim;
  context.lineWidth = 2.5;
  context.stroke();
  context.fillStyle = colour;
  context.fill();
  return pixels(context);
}

function machine(ink: string, rim: string, fill: string): ImageData {
  const context = canvas(30, 30);
  context.beginPath();
  context.moveTo(15, 2);
  context.lineTo(25, 26);
  context.lineTo(15, 21);
  context.lineTo(5, 26);
  context.closePath();
  context.lineJoin = 'round';
  context.strokeStyle = rim;
  context.lineWidth = 5;
  context.stroke();
  context.strokeStyle = ink;
  context.lineWidth = 2;
  context.fillStyle = fill;
  context.fill();
  context.stroke();
  return pixels(context);
}

/** Stripes, 8 × 8, that repeat without a seam. */
function hatch(paper: string, ink: string): ImageData {
  const context = canvas(8, 8);
  context.fillStyle = paper;
  context.fillRect(0, 0, 8, 8);
  context.strokeStyle = ink;
  context.lineWidth = 1.4;
  for (const x of [-8, 0, 8]) {
    context.beginPath();
    context.moveTo(x - 1, 9);
    context.lineTo(x + 9, -1);
    context.stroke();
  }
  return pixels(context);
}

function image(id: string, c: Colours): ImageData | null {
  const [kind, text = ''] = [id.slice(0, id.indexOf(':')), id.slice(id.indexOf(':') + 1)];
  switch (kind) {
    case 'name': return pill(text, c.Background, c.Ink, c.SubfieldEdge);
    case 'track': return pill(text, c.Background, c.Ink, c.Track);
    case 'gap': return pill(text, c.Uncovered, c.Background, c.Background);
    case 'obstacle': return pill(text, c.Obstacle, c.Background, c.Background);
    case 'arrow': return arrow(text === 'pass' ? c.HeadlandPass : text === 'guide' ? c.Reference : c.Track, c.Rim);
    case 'machine': return text === 'on' ? machine(c.Ink, c.Rim, '#35A853') : machine(c.Ink, c.Rim, c.IdlePath);
    case 'hatch': return text === 'obstacle' ? hatch(c.Obstacle, c.ObstacleHatch) : hatch(c.Passable, c.PassableHatch);
    default: return null;
  }
}

/** Gives the map every image it asks for, in the colours of the moment. */
export function drawLabels(map: GlMap, colours: () => Colours): void {
  map.on('styleimagemissing', ({ id }: { id: string }) => {
    const data = image(id, colours());
    if (data && !map.hasImage(id)) map.addImage(id, data, { pixelRatio: RATIO });
  });
}

/** After a change of theme all images are drawn anew when they are next asked for. */
export function forgetLabels(map: GlMap, colours: Colours): void {
  for (const id of map.listImages()) {
    const data = image(id, colours);
    if (data) map.updateImage(id, data);
  }
}
