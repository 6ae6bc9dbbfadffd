// Where things are: the repository, its build folder, and the per-user cache of what is expensive to make.
import { createHash } from 'node:crypto';
import { existsSync, readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url)).replace(/\/$/, '');
export const buildDir = join(root, 'build');
export const distDir = join(root, 'dist');
export const cacheDir = join(process.env.XDG_CACHE_HOME || join(homedir(), '.cache'), 'spineloft');
export const lock = JSON.parse(readFileSync(join(root, 'emsdk.lock'), 'utf8'));

/** The folder with real cases, or null: $SPINELOFT_DATA, or the one beside the repository. */
export const dataFolder =
  [process.env.SPINELOFT_DATA, join(root, '../shared/data/public')].find((folder) => folder && existsSync(folder)) ??
  null;

/** A short stable name for any JSON value: the cache key of what is made from it. */
export function shortHash(value) {
  return createHash('sha256').update(JSON.stringify(value)).digest('hex').slice(0, 12);
}
