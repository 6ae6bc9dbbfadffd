// npm start: set-up, build, and the page on http://localhost:8080 (or the next free port) until Ctrl-C.
import { existsSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { buildTargets } from './lib/cmake.mjs';
import { distDir } from './lib/paths.mjs';
import { mainProgram, say, Stop } from './lib/run.mjs';
import { serveFolder } from './lib/server.mjs';
import { assembleSite, enginePrograms, laterPath, siteTargets } from './lib/site.mjs';
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

/**
 * Builds the engine that this server's pages ask for first, and a site around it; then, behind it, the other engine and
 * the compressed twins. A page that asks for the other one meanwhile waits. `serve(later)` is called in between.
 */
async function buildAndServe(first, serve) {
  const second = Object.keys(enginePrograms).find((engine) => engine !== first);
  await buildTargets('wasm-release', siteTargets([first]));
  await assembleSite({ engines: [first], twins: false });
  let begin;
  const rest = new Promise((resolve) => (begin = resolve)).then(async () => {
    await buildTargets('wasm-release', siteTargets([second]));
    return assembleSite({ keep: true });
  });
  const site = await serve(new Map([[laterPath(second), rest.then((whole) => whole[second].js).catch(() => null)]]));
  begin();
  rest.then(
    () => say('The other engine and the compressed files are there too.'),
    (error) => say(`\nThe page works, but the rest of the site could not be built: ${error.message}`),
  );
  return site;
}

await mainProgram(async () => {
  const { port, host, 'no-isolation': plain, 'no-build': built } = options();
  if (!/^\d{1,5}$/.test(port)) throw new Stop(`--port wants a number, not ${port}.`);
  const serve = async (later) => {
    const site = await serveFolder(distDir, { port: Number(port), host, isolated: !plain, later });
    const how = plain ? ' (without the isolation headers: single thread)' : '';
    say(`\nSpineLoft is at ${site.url}${how}\nCtrl-C ends it.`);
    return site;
  };
  const stopped = new Promise((resolve) => process.on('spineloft-stop', resolve));
  let site;
  if (built) {
    if (!existsSync(distDir)) throw new Stop('There is no dist/ to serve: leave --no-build out.');
    site = await serve();
  } else {
    await setup(['wasm', 'node']);
    site = await buildAndServe(plain ? 'single' : 'threads', serve);
  }
  await stopped;
  await site.close();
  say('\nEnded.');
});
