// The per-user cache: a folder appears under its final name only when it is whole, and one process makes it at a time.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { cacheDir } from './paths.mjs';
import { duration, say, Stop } from './run.mjs';

/**
 * Holds the kernel's lock on `file` while `work` runs. The lock lives in a child process that ends with this one,
 * so nothing stale is left behind by a crash or a kill.
 */
async function withFileLock(file, work) {
  const holder = spawn('flock', ['-x', file, 'sh', '-c', 'echo held; exec cat >/dev/null'], {
    stdio: ['pipe', 'pipe', 'inherit'],
    detached: true,
  });
  const waiting = setTimeout(() => say('  another set-up is running; waiting for it to finish'), 2000);
  await new Promise((resolve, reject) => {
    holder.stdout.once('data', resolve);
    holder.once('error', () => reject(new Stop('The program flock (package util-linux) is missing.')));
    holder.once('exit', () => reject(new Stop(`Cannot lock ${file}.`)));
  });
  clearTimeout(waiting);
  try {
    return await work();
  } finally {
    holder.stdin.end();
  }
}

export async function withSetupLock(work) {
  mkdirSync(cacheDir, { recursive: true });
  return withFileLock(join(cacheDir, 'lock'), work);
}

/** Folders of runs that were interrupted; only the holder of the set-up lock may call this. */
export function removeLeftovers() {
  for (const name of readdirSync(cacheDir)) {
    if (name.startsWith('.making-')) rmSync(join(cacheDir, name), { recursive: true, force: true });
  }
}

/**
 * The folder `name` of the cache; if it is not there, `make(temporaryFolder, finalFolder)` fills a temporary one that
 * is renamed into place at the end.
 */
export async function cached(name, { what, howLong }, make) {
  const place = join(cacheDir, name);
  if (existsSync(place)) return place;
  say(`${what}: making it once for this user (${howLong})`);
  const started = Date.now();
  const temporary = mkdtempSync(join(cacheDir, '.making-'));
  try {
    await make(temporary, place);
    renameSync(temporary, place);
  } catch (error) {
    rmSync(temporary, { recursive: true, force: true });
    throw error;
  }
  say(`  done in ${duration(Date.now() - started)}`);
  return place;
}
