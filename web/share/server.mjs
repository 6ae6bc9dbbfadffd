// The share server: what a browser encrypted is kept for others who have the key, which is never sent here. Its requests
// are in models.mjs and rooms.mjs.
import rateLimit from '@fastify/rate-limit';
import fastify from 'fastify';
import { Counter, Gauge, Histogram, Registry } from 'prom-client';
import { Clock } from './clock.mjs';
import { Addresses, Misses } from './limiting.mjs';
import { kLimits } from './limits.mjs';
import { modelRoutes } from './models.mjs';
import { Refusal } from './refusal.mjs';
import { roomRoutes } from './rooms.mjs';
import { isId, secretOf } from './secrets.mjs';
import { StoreFull } from './store.mjs';
import { Watchers } from './watchers.mjs';

/** Of every answer: it runs nothing, is shown nowhere and kept nowhere. */
const kHeaders = {
  'Content-Security-Policy': "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; sandbox",
  'X-Content-Type-Options': 'nosniff',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'Referrer-Policy': 'no-referrer',
  'Cache-Control': 'no-store',
};

/** How long a client may take to send a request: options of Node's createServer. */
export const kTimes = {
  headersTimeout: 10_000,
  requestTimeout: 60_000,
  // Longer than the minute for which balancers keep a connection: none is closed here while a request is on its way.
  keepAliveTimeout: 75_000,
  connectionsCheckingInterval: 2000,
};

function helpers() {
  const idOf = (text) => {
    if (!isId(text)) throw new Refusal('BadRequest');
    return text;
  };
  const needSecret = (request) => {
    const secret = secretOf(request);
    if (!secret) throw new Refusal('NeedsSecret');
    return secret;
  };
  const bytesOf = ({ body }) => {
    if (!Buffer.isBuffer(body) || body.length === 0) throw new Refusal('BadRequest');
    return body;
  };
  const sendBytes = (reply, bytes) =>
    reply.header('Content-Disposition', 'attachment').type('application/octet-stream').send(bytes);
  return { idOf, needSecret, bytesOf, sendBytes };
}

/** Bodies that are received at one time are bounded, whoever sends them. */
function boundBodies(app) {
  let receiving = 0;
  const lengths = new WeakMap();
  app.addHook('onRequest', async (request) => {
    if (request.method !== 'PUT') return;
    const length = Number(request.headers['content-length']);
    if (!Number.isInteger(length)) {
      if (request.headers['transfer-encoding'] !== undefined) throw new Refusal('LengthMissing');
      return;
    }
    if (receiving + length > kLimits.receivingBytes && receiving > 0) throw new Refusal('Busy', 2);
    receiving += length;
    lengths.set(request, length);
    const release = () => {
      receiving -= lengths.get(request) ?? 0;
      lengths.delete(request);
    };
    request.raw.on('close', release);
  });
}

function measure(app, store, watchers) {
  const registry = new Registry();
  const registers = [registry];
  const requests = new Counter({
    name: 'spineloft_requests_total',
    help: 'Requests by what was asked and how they were answered',
    labelNames: ['method', 'route', 'status'],
    registers,
  });
  const seconds = new Histogram({
    name: 'spineloft_request_seconds',
    help: 'How long requests took',
    labelNames: ['route'],
    buckets: [0.005, 0.02, 0.1, 0.5, 2, 10],
    registers,
  });
  const gauge = (name, help, read) =>
    new Gauge({
      name: `spineloft_${name}`,
      help,
      registers,
      async collect() {
        this.set(await read());
      },
    });
  gauge('streams', 'Streams of events that are open', () => watchers.count);
  gauge('memory_bytes', 'Memory of the process', () => process.memoryUsage.rss());
  for (const what of ['models', 'rooms', 'posts', 'bytes'])
    gauge(`stored_${what}`, `Stored: ${what}`, async () => (await store.totals())[what]);
  app.addHook('onResponse', async ({ method, routeOptions }, { statusCode, elapsedTime }) => {
    const route = routeOptions.url ?? 'none';
    requests.inc({ method, route, status: statusCode });
    seconds.observe({ route }, elapsedTime / 1000);
  });
  return registry;
}

/** The refusal that an error is; null: nobody expected it. */
function refusalOf(error) {
  if (error instanceof Refusal) return error;
  if (error instanceof StoreFull) return new Refusal('ServerFull');
  if (error.statusCode === 413) return new Refusal('TooLarge');
  if (error.statusCode === 429) return new Refusal('TooMany');
  return error.statusCode >= 400 && error.statusCode < 500 ? new Refusal('BadRequest') : null;
}

function refuse(reply, refusal) {
  if (refusal.after) reply.header('Retry-After', String(refusal.after));
  return reply.headers(kHeaders).code(refusal.statusCode).send({ code: refusal.code, message: refusal.message });
}

/** What a failure is answered with. Only what nobody expected is logged, without who asked for what. */
function answerFailures(app, log) {
  app.setErrorHandler((error, request, reply) => {
    const known = refusalOf(error);
    if (!known) log(`${request.method} ${request.routeOptions.url ?? ''}: ${error.message}`);
    return refuse(reply, known ?? new Refusal('Failed'));
  });
  app.setNotFoundHandler(() => {
    throw new Refusal('NotThere');
  });
}

/**
 * The server on `store`. `log(line)` is told failures; `trustProxy`: addresses are taken from X-Forwarded-For. Resolves
 * to `{app, handle(request, response), close()}`; `app` is fastify's, ready.
 */
export async function makeShare({
  store,
  log = () => undefined,
  trustProxy = false,
  clock = new Clock(),
  limits = {},
}) {
  const app = fastify({
    logger: false,
    trustProxy,
    bodyLimit: 1024,
    routerOptions: { maxParamLength: 64, caseSensitive: true },
    // An address that cannot be read.
    frameworkErrors: (error, request, reply) => refuse(reply, new Refusal('BadRequest')),
    // Under the site or by itself.
    rewriteUrl: ({ url }) => url.replace(/^\/share(?=\/)/, ''),
  });
  const addresses = new Addresses();
  const misses = new Misses({ ...kLimits.wrongWords, ...limits.wrongWords });
  const watchers = new Watchers(store, clock, limits.beatMs);
  let isClosing = false;

  app.addHook('onRequest', async (request, reply) => {
    reply.headers(kHeaders);
    if (isClosing) throw new Refusal('Busy', 2);
  });
  answerFailures(app, log);
  await app.register(rateLimit, {
    global: true,
    ...kLimits.requests,
    ...limits.requests,
    cache: 20_000,
    keyGenerator: (request) => addresses.of(request),
  });
  boundBodies(app);
  const registry = measure(app, store, watchers);

  // No other body is read: nothing is parsed here.
  app.removeAllContentTypeParsers();
  app.addContentTypeParser('application/octet-stream', { parseAs: 'buffer' }, (request, body, done) =>
    done(null, body),
  );

  const tools = { store, clock, limits, addresses, misses, watchers, ...helpers() };
  modelRoutes(app, tools);
  roomRoutes(app, tools);
  app.get('/healthz', async () => {
    await store.totals();
    return { ok: true };
  });
  // For the machine itself: numbers are nobody else's business.
  app.get('/metrics', async (request, reply) => {
    const from = request.raw.socket.remoteAddress ?? '';
    const isOwn = /^(::1$|127\.|::ffff:127\.)/.test(from) && request.headers['x-forwarded-for'] === undefined;
    if (!isOwn) throw new Refusal('NotThere');
    return reply.type(registry.contentType).send(await registry.metrics());
  });
  await app.ready();

  const sweeping = setInterval(() => {
    store
      .sweep(clock.now())
      .then(() => store.scrub())
      .catch((error) => log(`sweep: ${error.message}`));
  }, limits.sweepMs ?? kLimits.sweepMs).unref();

  return {
    app,
    handle: (request, response) => app.routing(request, response),
    times: kTimes,
    /** How many streams of events are open. */
    streams: () => watchers.count,
    /** No request is taken any more, and the streams end: their readers come back, to another server or to this one. */
    endStreams() {
      isClosing = true;
      watchers.close();
    },
    /** When all requests are answered: closes the store. */
    async close() {
      this.endStreams();
      clearInterval(sweeping);
      await app.close();
      await store.close();
    },
  };
}
