// The service worker: after one visit the page opens without a network, and a release is never mixed with another. All
// files of a release are stored before it is used; the release in use stays until no page needs it or a visitor asks for
// the new one. Also takes pictures that the system's share sheet sends.
import './own_host.ts';
import { clientsClaim } from 'workbox-core';
import { cleanupOutdatedCaches, precacheAndRoute } from 'workbox-precaching';
import { registerRoute } from 'workbox-routing';
import { CacheFirst } from 'workbox-strategies';
import { kSharedCache, kSharePath, type WorkerAnswer, type WorkerRequest } from './protocol.ts';

interface ServiceWorkerEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface ServiceWorkerMessage extends ServiceWorkerEvent {
  readonly data: WorkerRequest;
  readonly ports: readonly MessagePort[];
}
const scope = globalThis as unknown as {
  readonly clients: { matchAll(options: { type: 'window'; includeUncontrolled: boolean }): Promise<unknown[]> };
  skipWaiting(): Promise<void>;
  addEventListener(type: 'message', listener: (event: ServiceWorkerMessage) => void): void;
  addEventListener(type: 'activate', listener: (event: ServiceWorkerEvent) => void): void;
};

/** Which of the two engines the page runs; the other one, and what few need, is stored when it is first asked for. */
const engine = new URL(location.href).searchParams.get('engine') === 'threads' ? 'threads' : 'single';
const kLaterCache = 'spineloft-later';

cleanupOutdatedCaches();
precacheAndRoute([...SPINELOFT_FILES.page, ...SPINELOFT_FILES[engine]], {
  directoryIndex: 'index.html',
  // A link's parameters are the page's business.
  ignoreURLParametersMatching: [/./],
});

const others = new Set(
  [...SPINELOFT_FILES.threads, ...SPINELOFT_FILES.single, ...SPINELOFT_FILES.rare].map(
    ({ url }) => new URL(url, location.href).href,
  ),
);
registerRoute(({ url }) => others.has(url.href), new CacheFirst({ cacheName: kLaterCache }));
scope.addEventListener('activate', (event) => {
  const tidy = async () => {
    const cache = await caches.open(kLaterCache);
    for (const { url } of await cache.keys()) if (!others.has(url)) await cache.delete(url);
  };
  event.waitUntil(tidy());
});

// A page that loaded before there was a service worker needs it too, when its network goes.
clientsClaim();

registerRoute(
  ({ url }) => url.pathname === new URL(kSharePath, location.href).pathname,
  async ({ request }) => {
    const cache = await caches.open(kSharedCache);
    for (const [index, file] of (await request.formData()).getAll('files').entries()) {
      if (typeof file === 'string') continue;
      const headers = { 'Content-Type': file.type, 'X-Name': encodeURIComponent(file.name) };
      await cache.put(
        new URL(`${kSharePath}/${Date.now()}-${index}`, location.href).href,
        new Response(file, { headers }),
      );
    }
    return Response.redirect(new URL('./?shared', location.href).href, 303);
  },
  'POST',
);

async function useNow(): Promise<WorkerAnswer> {
  const pages = await scope.clients.matchAll({ type: 'window', includeUncontrolled: true });
  if (pages.length > 1) return { begun: false };
  await scope.skipWaiting();
  return { begun: true };
}

scope.addEventListener('message', (event) => {
  if (event.data.type === 'use-now') event.waitUntil(useNow().then((answer) => event.ports[0]?.postMessage(answer)));
});
