// The page's side of its service worker: starts it, offers a new release, and takes files from the system.
import { hideBanner, showBanner } from '../banner.ts';
import { toast } from '../toasts.ts';
import { kSharedCache, type WorkerAnswer, type WorkerRequest } from './protocol.ts';

const kBanner = 'new-release';
/** How often an open page looks for a new release. */
const kLookMs = 3_600_000;

export interface OfflineHost {
  /** True while loading the page again would lose something. */
  hasUnsavedWork(): boolean;
}

function ask(worker: ServiceWorker, request: WorkerRequest): Promise<WorkerAnswer> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => resolve(data as WorkerAnswer);
    worker.postMessage(request, [port2]);
  });
}

async function useNow(worker: ServiceWorker, host: OfflineHost): Promise<void> {
  if (host.hasUnsavedWork()) {
    toast('Save a file first: this browser does not keep your model.', 'warning');
    return;
  }
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  const { begun } = await ask(worker, { type: 'use-now' });
  if (!begun) toast('SpineLoft is open in another tab or window. Close it there, then press again.', 'warning');
}

function offer(worker: ServiceWorker, host: OfflineHost): void {
  showBanner({
    id: kBanner,
    text: 'There is a new version of SpineLoft. Your models stay as they are.',
    actions: [{ label: 'Use it now', run: () => void useNow(worker, host) }],
    canDismiss: true,
  });
}

function watch(registration: ServiceWorkerRegistration, host: OfflineHost): void {
  // Without a controller it is the first release, and nothing is replaced.
  const offerWaiting = () => {
    if (registration.waiting && navigator.serviceWorker.controller) offer(registration.waiting, host);
  };
  offerWaiting();
  registration.addEventListener('updatefound', () => {
    const worker = registration.installing;
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'installed') offerWaiting();
      if (worker.state === 'activated' || worker.state === 'redundant') hideBanner(kBanner);
    });
  });
  setInterval(() => {
    if (document.visibilityState === 'visible') void registration.update().catch(() => undefined);
  }, kLookMs);
}

/** Stores the page for use without a network. Where the browser or the host has no service workers, nothing happens. */
export async function startOffline(host: OfflineHost): Promise<void> {
  if (!('serviceWorker' in navigator) || SPINELOFT_SITE.serviceWorker === '') return;
  const address = new URL(SPINELOFT_SITE.serviceWorker, document.baseURI);
  address.searchParams.set('engine', globalThis.crossOriginIsolated ? 'threads' : 'single');
  try {
    watch(await navigator.serviceWorker.register(address.href, { updateViaCache: 'none' }), host);
  } catch {
    // Without one the page works as long as there is a network.
  }
}

/** Files that the share sheet or the file manager sent, now and later. */
export function receiveFiles(open: (files: File[]) => void): void {
  void sharedFiles().then((files) => files.length > 0 && open(files));
  const { launchQueue } = globalThis as unknown as {
    launchQueue?: { setConsumer(take: (launch: { files: { getFile(): Promise<File> }[] }) => void): void };
  };
  launchQueue?.setConsumer(({ files }) => {
    if (files.length > 0) void Promise.all(files.map((file) => file.getFile())).then(open);
  });
}

async function sharedFiles(): Promise<File[]> {
  const address = new URL(location.href);
  if (!address.searchParams.has('shared')) return [];
  address.searchParams.delete('shared');
  history.replaceState(null, '', address);
  const cache = await caches.open(kSharedCache);
  const files: File[] = [];
  for (const request of await cache.keys()) {
    const response = await cache.match(request);
    if (!response) continue;
    const type = response.headers.get('Content-Type') ?? '';
    files.push(new File([await response.blob()], decodeURIComponent(response.headers.get('X-Name') ?? ''), { type }));
    await cache.delete(request);
  }
  return files;
}
