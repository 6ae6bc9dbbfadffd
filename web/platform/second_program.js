// Functions that a first part does without are a program of their own (see SECOND_OBJECTS in web/CMakeLists.txt). The page
// fetches it once it can be used; whoever calls one of them earlier, or on a thread, waits for it here.
// Emscripten puts this at the beginning of its loader: on the page and in every thread.
const ownImports = getWasmImports;
let isSecondThere = false;

function secondAddress() {
  return new URL('spineloft_second.wasm', import.meta.url);
}

function startSecond(program) {
  if (isSecondThere) return;
  new WebAssembly.Instance(program, { primary: wasmExports });
  isSecondThere = true;
}

/** The server answers that there is no such file, as where another release took the place of this one. */
class Gone extends Error {}

function fetchSecondAtOnce() {
  const request = new XMLHttpRequest();
  request.open('GET', secondAddress(), false);
  // The one way to bytes that a request without waiting has on a page.
  request.overrideMimeType('text/plain; charset=x-user-defined');
  request.send();
  const why = `${secondAddress()}: ${request.status}`;
  if (request.status >= 400 && request.status < 500) throw new Gone(why);
  if (request.status !== 200) throw new Error(why);
  return Uint8Array.from(request.responseText, (letter) => letter.charCodeAt(0));
}

/** How often it is asked for where the network is away: what calls it cannot go on otherwise. */
const kTries = 30;
const kPauseMs = 1000;

function secondAtOnce() {
  for (let tries = 1; ; tries += 1) {
    try {
      return new WebAssembly.Module(fetchSecondAtOnce());
    } catch (thrown) {
      if (thrown instanceof Gone) Module['loadAgain']?.();
      if (thrown instanceof Gone || tries === kTries) throw thrown;
    }
    if (Module['askForNetwork']) Module['askForNetwork']();
    else Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, kPauseMs);
  }
}

/** A table of its own holds the functions that the first program calls: placeholders, until the second one is there. */
function called(slot) {
  const tables = Object.entries(wasmExports).filter(
    ([name, value]) => name[0] === '%' && value instanceof WebAssembly.Table,
  );
  return tables[0][1].get(slot);
}

getWasmImports = () => ({
  ...ownImports(),
  placeholder: new Proxy(
    {},
    {
      get:
        (_, slot) =>
        (...values) => {
          startSecond(secondAtOnce());
          return called(Number(slot))(...values);
        },
    },
  ),
});

/** Resolves when all functions are there, on this thread. */
Module['fetchSecond'] = async (compile) => startSecond(await compile(secondAddress().href));
