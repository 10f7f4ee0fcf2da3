// Writes the .cpp that puts every file of a folder, and its gzip, into the program.
import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';

const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.png': 'image/png',
};

export function writeTable(folder, table) {
  const packed = `${folder}-gzip`;
  rmSync(packed, { recursive: true, force: true });
  mkdirSync(packed, { recursive: true });
  const files = readdirSync(folder).sort((a, b) => (a < b ? -1 : 1));
  const blobs = [];
  const rows = [];
  files.forEach((file, i) => {
    const type = types[extname(file)];
    if (!type) throw new Error(`table.mjs: no content type for ${file}`);
    const bytes = readFileSync(join(folder, file));
    const gzip = gzipSync(bytes, { level: 9 });
    gzip[9] = 0xff; // which system packed it is nobody's business, and would differ
    blobs.push(blob(`f${i}`, join(folder, file)));
    const shorter = gzip.length < bytes.length;
    if (shorter) {
      writeFileSync(join(packed, `${file}.gz`), gzip);
      blobs.push(blob(`z${i}`, join(packed, `${file}.gz`)));
    }
    const etag = createHash('sha256').update(bytes).digest('hex').slice(0, 32);
    const lasting = /-[A-Z0-9]{8}\.(js|css)$/.test(file);
    rows.push(
      `    Asset{"/${file}", view(f${i}, f${i}_end), ${shorter ? `view(z${i}, z${i}_end)` : '{}'},\n` +
        `          "${type}", "\\"${etag}\\"", ${lasting}},`,
    );
  });
  writeFileSync(
    table,
    `// Made by web/tools/table.mjs.\n#include <array>\n\n#include "page/page_asset.h"\n\n${blobs.join('\n')}\n
namespace tramline::app {
namespace {

std::string_view view(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

const std::array kAssets = {
${rows.join('\n')}
};

}  // namespace

std::span<const Asset> page_assets() { return kAssets; }

}  // namespace tramline::app
`,
  );
}

function blob(name, path) {
  const symbol = `tramline_page_${name}`;
  return `__asm__(
    ".section .rodata\\n.balign 16\\n.global ${symbol}\\n${symbol}:\\n.incbin \\"${path}\\"\\n"
    ".global ${symbol}_end\\n${symbol}_end:\\n.byte 0\\n.previous\\n");
extern "C" const char ${name}[] __asm__("${symbol}");
extern "C" const char ${name}_end[] __asm__("${symbol}_end");`;
}
