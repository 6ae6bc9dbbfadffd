// npm run cli -- ...: builds the native command-line program and runs it with the given arguments.
// What the set-up and the build say goes to standard error, so that the program's own output stays clean.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { mainProgram, talkOnStderr } from './lib/run.mjs';
import { setup } from './setup.mjs';

await mainProgram(async () => {
  talkOnStderr();
  await setup(['native']);
  await buildTargets('native-release', ['spineloft']);
  const program = join(presetDir('native-release'), 'spineloft');
  const cwd = process.env.INIT_CWD ?? process.cwd();
  return spawnSync(program, process.argv.slice(2), { stdio: 'inherit', cwd }).status ?? 1;
});
