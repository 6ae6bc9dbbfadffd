// From a share text to what is shown: the page's own engine derives the model. A module of its own, loaded when a text
// is to be shown; a viewer of a GLB never loads it.
import type { Engine } from '../engine.ts';
import { photosIn } from '../link_photos.ts';
import { kLinkMark } from '../links.ts';
import { startEngine } from '../start_engine.ts';

const kPollMs = 12;
/** Nobody sees what it draws. */
const kSize = { width: 16, height: 16, dpr: 1 };

/** Nothing is pending: twice in a row, since finished work may start the next stage. */
async function idle(engine: Engine): Promise<void> {
  for (let quiet = 0; quiet < 2;) {
    quiet = engine.isIdle() ? quiet + 1 : 0;
    await new Promise((resolve) => setTimeout(resolve, kPollMs));
  }
}

let starting: Promise<Engine> | null = null;

/** The finished model of a share text as a GLB, and its name. Rejects with a Failure. */
export async function derived(text: string): Promise<{ glb: Uint8Array; name: string }> {
  starting ??= startEngine(
    document.createElement('canvas'),
    () => undefined,
    () => kSize,
  );
  const engine = await starting.catch((thrown: unknown) => {
    starting = null; // another try may do better
    throw thrown;
  });
  await engine.whole();
  const link = new TextEncoder().encode(kLinkMark + text);
  engine.openProject(link, await photosIn(engine, link));
  const { name } = engine.about();
  await idle(engine);
  engine.finishParts();
  await idle(engine);
  return { glb: engine.exportModel('glb'), name };
}
