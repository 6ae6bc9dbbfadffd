// Set-up: everything the builds need, found or made, and written down in build/deps.cmake for CMake.
// Safe to interrupt and to run again; does nothing that is already done.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { removeLeftovers, withSetupLock } from './lib/cache.mjs';
import { closePinnedSuite, installGroups, installIfPossible } from './lib/debian.mjs';
import { findEmscripten } from './lib/emscripten.mjs';
import { compileNativeModules } from './lib/native_modules.mjs';
import { installNodePackages } from './lib/node_packages.mjs';
import { buildDir, cacheDir, lock } from './lib/paths.mjs';
import { duration, logFile, mainProgram, say } from './lib/run.mjs';
import { headers, imguiSources, makeOpencv, opencvFolder, toolchainFile } from './lib/libraries.mjs';

function writeIfChanged(file, text) {
  if (!existsSync(file) || readFileSync(file, 'utf8') !== text) writeFileSync(file, text);
}

function writeFacts(facts) {
  const file = join(buildDir, 'deps.cmake');
  const before = existsSync(file) ? readFileSync(file, 'utf8').matchAll(/^set\(SPINELOFT_(\w+) "(.*)"\)$/gm) : [];
  const all = { ...Object.fromEntries([...before].map(([, key, value]) => [key, value])), ...facts };
  const lines = Object.keys(all)
    .sort()
    .map((key) => `set(SPINELOFT_${key} "${all[key]}")`);
  writeIfChanged(
    file,
    ['# Written by .ci/setup.mjs: where the libraries are on this machine.', ...lines, ''].join('\n'),
  );
  if (facts.EMSCRIPTEN_TOOLCHAIN) {
    writeIfChanged(
      join(buildDir, 'emscripten.cmake'),
      [
        '# Written by .ci/setup.mjs: the toolchain file of the wasm presets.',
        `include("${facts.EMSCRIPTEN_TOOLCHAIN}")`,
        '',
      ].join('\n'),
    );
  }
}

/** Where the libraries are, which are made if they are not there yet. */
async function findFacts(parts) {
  const facts = { CACHE_DIR: cacheDir, DEPS_INCLUDE: await headers(), IMGUI_DIR: await imguiSources() };
  if (!parts.includes('wasm')) return facts;
  const emscripten = await findEmscripten();
  if (parts.includes('opencv')) await makeOpencv(emscripten);
  return {
    ...facts,
    EMSCRIPTEN_ROOT: emscripten,
    EMSCRIPTEN_TOOLCHAIN: toolchainFile(emscripten),
    OPENCV_WASM_DIR: opencvFolder,
    WASM_FLAGS: lock.wasmFlags,
  };
}

async function nodeModules(parts) {
  const isStoreWanted = parts.includes('store');
  if (parts.includes('node') || isStoreWanted) await installNodePackages();
  if (isStoreWanted) await compileNativeModules();
}

/** Waits for the end of every one of these, also where one fails. */
async function all(promises) {
  const failed = (await Promise.allSettled(promises)).find(({ status }) => status === 'rejected');
  if (failed) throw failed.reason;
}

/**
 * Prepares the machine for the given parts: native, wasm (with opencv: for programs that cut out, too), browser, node (npm
 * packages), store (with these the SQLite of the share server, which is compiled), database (PostgreSQL for tests of the
 * share server), readers (programs that some tests have read what was saved, where they can be installed). Parts that
 * were prepared before for this checkout stay prepared.
 */
export async function setup(parts = ['native', 'wasm', 'opencv', 'browser', 'node', 'store']) {
  const started = Date.now();
  mkdirSync(buildDir, { recursive: true });
  rmSync(logFile('setup'), { force: true });
  await withSetupLock(async () => {
    removeLeftovers();
    await installGroups(['base', 'headers', ...parts.filter((part) => part !== 'readers')]);
    if (parts.includes('readers')) await installIfPossible('readers');
    try {
      // Downloads and a compiler on one core do not wait for each other.
      await all([nodeModules(parts), findFacts(parts).then(writeFacts)]);
    } finally {
      closePinnedSuite();
    }
  });
  say(`Set-up is complete (${duration(Date.now() - started)}).`);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const parts = process.argv.slice(2);
  await mainProgram(() => setup(parts.length ? parts : undefined));
}
