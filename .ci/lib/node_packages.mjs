// npm packages, installed exactly as package-lock.json says, and only when it changed.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, shortHash } from './paths.mjs';
import { run, say } from './run.mjs';

export async function installNodePackages() {
  const wanted = shortHash([readFileSync(join(root, 'package-lock.json'), 'utf8'), process.versions.modules]);
  const stamp = join(root, 'node_modules/.spineloft-installed');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return;
  say('npm packages: installing the versions of package-lock.json (half a minute)');
  const args = ['ci', '--no-audit', '--no-fund', '--ignore-scripts'];
  await run('npm ci', 'npm', args, { cwd: root });
  writeFileSync(stamp, wanted);
}
