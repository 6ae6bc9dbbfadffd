// The engine as the page and the viewer start it.
import { loadEngine } from './engine.ts';
import type { Engine, EngineEvent, Size } from './engine.ts';
import { Failure } from './failure.ts';
import { loadFonts } from './fonts.ts';
import { hasWebGl2 } from './surface.ts';

/** Why this browser cannot run the page, or null. */
function missing(): Failure | null {
  if (typeof WebAssembly !== 'object') {
    return new Failure(
      'NoWebAssembly',
      'This browser has no WebAssembly, which SpineLoft needs. Update the browser, or open the page in a current Chrome, Edge, Firefox or Safari.',
    );
  }
  if (!hasWebGl2()) {
    return new Failure(
      'NoWebGL2',
      'This browser cannot draw in 3D: WebGL 2 is missing or switched off. Switch on graphics acceleration in its settings, or try another browser.',
    );
  }
  return null;
}

/** A running engine that draws on `canvas`, `size()` large. Rejects with a Failure. */
export async function startEngine(
  canvas: HTMLCanvasElement,
  onEvent: (event: EngineEvent) => void,
  size: () => Size,
): Promise<Engine> {
  const failure = missing();
  if (failure) throw failure;
  try {
    const [engine, fonts] = await Promise.all([loadEngine(canvas, onEvent), loadFonts()]);
    if (!engine.start(fonts, size())) throw new Error('the engine did not start');
    return engine;
  } catch (thrown) {
    console.warn(thrown);
    throw new Failure(
      'EngineNotLoaded',
      'SpineLoft did not load completely. Check the connection and load the page again.',
    );
  }
}
