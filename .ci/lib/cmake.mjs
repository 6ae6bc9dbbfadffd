// Building CMake targets through the presets.
import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { buildDir, root } from './paths.mjs';
import { duration, run, say } from './run.mjs';

/** The folder of a preset's build. */
export function presetDir(preset) {
  return join(buildDir, preset);
}

/** Configures the preset if it never was, and builds the targets; says how long it took when anything was done. */
export async function buildTargets(preset, targets) {
  const folder = presetDir(preset);
  const started = Date.now();
  if (!existsSync(join(folder, 'build.ninja'))) {
    await run(`configuring ${preset}`, 'cmake', ['--preset', preset], { cwd: root, log: preset });
  }
  const jobs = process.env.SPINELOFT_JOBS ?? String(availableParallelism());
  const args = ['--build', folder, '-j', jobs, '--target', ...targets];
  const { text } = await run(`building ${preset}`, 'cmake', args, { cwd: root, log: preset });
  const compiled = (text.match(/^\[\d+\/\d+\] (Building|Linking)/gm) ?? []).length;
  say(`${preset}: ${compiled ? `${compiled} steps in ${duration(Date.now() - started)}` : 'nothing to do'}`);
}
