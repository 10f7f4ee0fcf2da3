// Installs what a package-lock.json names, that of the page unless another folder is named, once for each state of that file.
// Usage: packages.mjs [NPM [FOLDER]]
import { createHash } from 'node:crypto';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = process.argv[3] ?? dirname(dirname(fileURLToPath(import.meta.url)));
const stamp = join(folder, 'node_modules', '.tramline-lock');
const lock = createHash('sha256').update(readFileSync(join(folder, 'package-lock.json'))).digest('hex');

if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== lock) {
  // No package needs its install script; none is run.
  const npm = spawnSync(process.argv[2] ?? 'npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: folder,
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  if (npm.status !== 0) {
    console.error(
      'packages.mjs: npm could not install the packages of the page, or of its tests. Look at its messages above; they need the ' +
        'npm registry once, or build without the page: cmake -DTRAMLINE_PAGE=OFF',
    );
    process.exit(1);
  }
  writeFileSync(stamp, lock);
}
