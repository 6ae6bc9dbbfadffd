// The share server by itself: what `npm run serve:share` starts.
import { createServer } from 'node:http';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

export const kUsage =
  'Usage: npm run serve:share -- [--port N] [--host NAME] [--store FILE|postgres://...] [--disk MEGABYTES] ' +
  '[--trust-proxy] [--backup FILE]';

/** Where models and rooms are kept unless another place is named. */
export const defaultStore = join(
  process.env.XDG_DATA_HOME || join(homedir(), '.local/share'),
  'spineloft',
  'share.sqlite',
);

/** Megabytes that the file of the store may have unless another number is named. */
export const defaultDisk = 20_000;

export class UsageError extends Error {}

export function serveOptions(args) {
  let values;
  try {
    values = parseArgs({
      args,
      options: {
        port: { type: 'string', default: '8090' },
        host: { type: 'string', default: 'localhost' },
        store: { type: 'string', default: process.env.SPINELOFT_STORE || defaultStore },
        disk: { type: 'string', default: String(defaultDisk) },
        'trust-proxy': { type: 'boolean', default: false },
        backup: { type: 'string' },
      },
    }).values;
  } catch (error) {
    throw new UsageError(`${error.message}\n${kUsage}`);
  }
  for (const name of ['port', 'disk'])
    if (!/^\d{1,9}$/.test(values[name])) throw new UsageError(`--${name} wants a number, not ${values[name]}.`);
  return values;
}

/** Starts what `options` say; resolves to `{url, close()}`. Failures of the server go to `log`. */
export async function startShare(options, log) {
  const { openStore } = await import('./store.mjs');
  const { makeShare } = await import('./server.mjs');
  const store = await openStore(options.store, { diskBytes: Number(options.disk) * 2 ** 20 });
  const share = await makeShare({ store, log, trustProxy: options['trust-proxy'] });
  const server = createServer(share.times, share.handle);
  await new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(Number(options.port), options.host, resolve);
  });
  return {
    url: `http://localhost:${server.address().port}/`,
    /** Answers what was asked before, then ends. */
    async close() {
      const ended = new Promise((resolve) => server.close(resolve));
      server.closeIdleConnections();
      const ending = setTimeout(() => server.closeAllConnections(), 5000);
      await share.endStreams();
      await ended;
      clearTimeout(ending);
      await share.close();
    },
  };
}

/** Copies the store to `file` while servers go on. */
export async function backUp(options) {
  const { openStore } = await import('./store.mjs');
  const store = await openStore(options.store);
  try {
    await store.backup(options.backup);
  } finally {
    await store.close();
  }
}

/** The program; `say` prints a line, `stopped` resolves when it is to end. */
export async function serveMain(args, { say, stopped }) {
  const options = serveOptions(args);
  if (options.backup !== undefined) {
    await backUp(options);
    return say(`Written: ${options.backup}`);
  }
  const share = await startShare(options, say);
  say(`The share server is at ${share.url}\nCtrl-C ends it.`);
  await stopped;
  await share.close();
  say('Ended.');
}
