// The worker that cuts things out of pictures: one request after the other, a round at a time. A newer request ends the
// older one at the next round.
import { CutOut } from './cut_out/program.ts';
import type { CutMessage, CutRequest, CutStop } from './cut_out/protocol.ts';
import { hold } from './lifeline.ts';
import { breathe, bytesOf, rethrow } from './worker_side.ts';

const scope = globalThis as unknown as {
  name: string;
  postMessage(message: CutMessage, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<CutRequest | CutStop>) => void) | null;
};

// Its address is relative to the page, this script lies among the page's assets.
const starting = bytesOf(`../${SPINELOFT_SITE.cutOut}`, import.meta.url).then((bytes) => CutOut.load(bytes));
starting.then(() => scope.postMessage({ type: 'ready' }, [])).catch(rethrow);

hold(scope.name, () => scope.postMessage({ type: 'alive' }, []));

let newest = 0;
let queue = Promise.resolve();

async function search({ id, hints, picture }: CutRequest): Promise<void> {
  const cutOut = await starting;
  // Also of a request that nobody waits for: the next one may count on it.
  if (picture) cutOut.show(picture);
  if (id !== newest) return;
  const rounds = cutOut.search(hints);
  for (let round = rounds.next(); ; round = rounds.next()) {
    if (round.done) {
      const found = round.value;
      scope.postMessage({ type: 'found', id, found, bytes: cutOut.memory }, [found.buffer as ArrayBuffer]);
      return;
    }
    scope.postMessage({ type: 'progress', id, done: round.value }, []);
    await breathe();
    if (id !== newest) return;
  }
}

scope.onmessage = ({ data }) => {
  newest = 'stop' in data ? 0 : data.id;
  if ('stop' in data) return;
  queue = queue.then(() => search(data)).catch(rethrow);
};
