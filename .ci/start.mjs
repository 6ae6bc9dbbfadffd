// npm start: set-up, build, and the page on http://localhost:8080 (or the next free port) until Ctrl-C.
import { existsSync } from 'node:fs';
import { isIP } from 'node:net';
import { networkInterfaces } from 'node:os';
import { parseArgs } from 'node:util';
import { buildTargets } from './lib/cmake.mjs';
import { distDir } from './lib/paths.mjs';
import { mainProgram, say, Stop } from './lib/run.mjs';
import { serveFolder } from './lib/server.mjs';
import { assembleSite, laterPath, siteParts, siteTargets } from './lib/site.mjs';
import { setup } from './setup.mjs';

function options() {
  try {
    return parseArgs({
      options: {
        port: { type: 'string', default: process.env.PORT ?? '8080' },
        host: { type: 'string', default: 'localhost' },
        store: { type: 'string' },
        https: { type: 'boolean', default: false },
        'no-share': { type: 'boolean', default: false },
        'no-isolation': { type: 'boolean', default: false },
        'no-build': { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    throw new Stop(
      `${error.message}\nUsage: npm start -- [--port N] [--host NAME] [--https] [--store FILE] [--no-share] [--no-isolation] [--no-build]`,
    );
  }
}

/** Addresses of this machine in its network; none while the server listens to the machine itself alone. */
function networkAddresses(host) {
  if (host === 'localhost' || host.startsWith('127.')) return [];
  if (host !== '0.0.0.0' && host !== '::') return [host];
  const all = Object.values(networkInterfaces()).flat();
  return all.filter(({ family, internal }) => family === 'IPv4' && !internal).map(({ address }) => address);
}

/** The share server beside the site, once its libraries are there; where nobody prepares them yet, they are now. */
async function shareServer(store, isReady = setup(['store'])) {
  await isReady;
  const { openStore } = await import('../web/share/store.mjs');
  const { makeShare } = await import('../web/share/server.mjs');
  const { defaultDisk, defaultStore } = await import('../web/share/serve.mjs');
  return makeShare({ store: await openStore(store ?? defaultStore, { diskBytes: defaultDisk * 2 ** 20 }), log: say });
}

/** A key and a certificate for these names, good for this run. */
async function certificate(names) {
  const { generate } = await import('selfsigned');
  const altNames = ['localhost', '127.0.0.1', ...names].map((name) =>
    isIP(name) ? { type: 7, ip: name } : { type: 2, value: name },
  );
  const { private: key, cert } = await generate([{ name: 'commonName', value: 'SpineLoft' }], {
    keyType: 'ec',
    extensions: [{ name: 'subjectAltName', altNames }],
  });
  return { key, cert };
}

/**
 * Builds the engine that this server's pages ask for first, and a site around it; then, behind it, OpenCV and the search
 * for cut-outs, the other engine and the compressed twins. A page that asks for one of these meanwhile waits.
 * `serve(later)` is called in between.
 */
async function buildAndServe(first, serve) {
  await buildTargets('wasm-release', siteTargets([first]));
  await assembleSite({ parts: [first], twins: false });
  let begin;
  const cutOut = new Promise((resolve) => (begin = resolve)).then(async () => {
    await setup(['wasm', 'opencv', 'node']);
    await buildTargets('wasm-release', siteTargets(['cutOut']));
    return assembleSite({ parts: [first, 'cutOut'], keep: true, twins: false });
  });
  const rest = cutOut.then(async () => {
    await buildTargets('wasm-release', siteTargets());
    return assembleSite({ keep: true });
  });
  const pathIn = (site, part) => site.then((made) => made[part].js ?? made[part]).catch(() => null);
  const later = siteParts
    .filter((part) => part !== first)
    .map((part) => [laterPath(part), pathIn(part === 'cutOut' ? cutOut : rest, part)]);
  const site = await serve(new Map(later));
  begin();
  let ended = false;
  process.on('spineloft-stop', () => (ended = true));
  rest.then(
    () => say('Cut-outs, the other engine and the compressed files are there too.'),
    (error) => ended || say(`\nThe page works, but the rest of the site could not be built: ${error.message}`),
  );
  return site;
}

await mainProgram(async () => {
  const { port, host, https, store, 'no-share': alone, 'no-isolation': plain, 'no-build': built } = options();
  if (!/^\d{1,5}$/.test(port)) throw new Stop(`--port wants a number, not ${port}.`);
  const names = networkAddresses(host);
  let share;
  const serve = async ({ later, storeIsReady } = {}) => {
    const tls = https ? await certificate(names) : undefined;
    if (!alone) share = await shareServer(store, storeIsReady);
    const beside = share && { ...share, addresses: [] };
    const site = await serveFolder(distDir, { port: Number(port), host, isolated: !plain, later, share: beside, tls });
    const addresses = names.map((name) => site.url.replace('localhost', name));
    beside?.addresses.push(...addresses);
    const how = plain ? ' (without the isolation headers: single thread)' : '';
    say(`\nSpineLoft is at ${[site.url, ...addresses].join(' and ')}${how}\nCtrl-C ends it.`);
    return site;
  };
  const stopped = new Promise((resolve) => process.on('spineloft-stop', resolve));
  let site;
  if (built) {
    if (!existsSync(distDir)) throw new Stop('There is no dist/ to serve: leave --no-build out.');
    site = await serve();
  } else {
    await setup(['wasm', 'node']);
    // A compiler on one core, beside the engine's.
    const storeIsReady = alone ? undefined : setup(['store']);
    storeIsReady?.catch(() => {}); // told by the server, which waits for it
    site = await buildAndServe(plain ? 'single' : 'threads', (later) => serve({ later, storeIsReady }));
  }
  await stopped;
  share?.endStreams();
  await site.close();
  await share?.close();
  say('\nEnded.');
});
