// npm start: set-up, build, and the page on http://localhost:8080 (or the next free port) until Ctrl-C.
import { existsSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { buildSite } from './build.mjs';
import { distDir } from './lib/paths.mjs';
import { mainProgram, say, Stop } from './lib/run.mjs';
import { serveFolder } from './lib/server.mjs';
import { setup } from './setup.mjs';

function options() {
  try {
    return parseArgs({
      options: {
        port: { type: 'string', default: process.env.PORT ?? '8080' },
        host: { type: 'string', default: 'localhost' },
        'no-isolation': { type: 'boolean', default: false },
        'no-build': { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    throw new Stop(`${error.message}\nUsage: npm start -- [--port N] [--host NAME] [--no-isolation] [--no-build]`);
  }
}

await mainProgram(async () => {
  const { port, host, 'no-isolation': plain, 'no-build': built } = options();
  if (!/^\d{1,5}$/.test(port)) throw new Stop(`--port wants a number, not ${port}.`);
  if (!built) {
    await setup(['wasm', 'node']);
    await buildSite();
  }
  if (!existsSync(distDir)) throw new Stop('There is no dist/ to serve: leave --no-build out.');
  const site = await serveFolder(distDir, { port: Number(port), host, isolated: !plain });
  say(
    `\nSpineLoft is at ${site.url}${plain ? ' (without the isolation headers: single thread)' : ''}\nCtrl-C ends it.`,
  );
  await new Promise((resolve) => process.on('spineloft-stop', resolve));
  await site.close();
  say('\nEnded.');
});
