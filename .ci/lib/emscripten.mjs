// Finding Emscripten at exactly the pinned version: on the PATH or under $EMSDK, installed by apt, or composed from
// the packages of a newer Debian into the per-user cache.
import {
  chmodSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { cached } from './cache.mjs';
import { pinnedSuite, release, verify } from './debian.mjs';
import { lock, shortHash } from './paths.mjs';
import { output, run, say, Stop } from './run.mjs';

const pin = lock.emscripten;
// Whatever changes how the prefix is put together raises this, so that old caches are not reused.
const kRecipe = 1;

/** The Emscripten root folder (the one that holds emcc.py and cmake/) behind an emcc of the pinned version, or null. */
function rootOf(emcc) {
  const version = output(emcc, ['-dumpversion']);
  if (version !== pin.version) return null;
  const folder = join(realpathSync(emcc), '..');
  const candidates = [folder, '/usr/share/emscripten'];
  return candidates.find((place) => existsSync(join(place, 'cmake/Modules/Platform/Emscripten.cmake'))) ?? null;
}

function installedRoot() {
  const onPath = output('sh', ['-c', 'command -v emcc']);
  const sdk = process.env.EMSDK;
  const candidates = [onPath, sdk && join(sdk, 'upstream/emscripten/emcc'), sdk && join(sdk, 'emcc')];
  for (const emcc of candidates) {
    const root = emcc && existsSync(emcc) ? rootOf(emcc) : null;
    if (root) return root;
  }
  return null;
}

function architecture() {
  return output('dpkg', ['--print-architecture']);
}

/** Binaryen needs a newer C library than Debian 12 has: each tool is run through the loader of that library. */
function wrapBinaryen(prefix) {
  const bin = join(prefix, 'binaryen/bin');
  mkdirSync(bin, { recursive: true });
  const triplet = output('gcc', ['-print-multiarch']);
  const libraries = join(prefix, 'rt/usr/lib', triplet);
  const loader = readdirSync(libraries).find((name) => /^ld-linux.*\.so/.test(name));
  for (const tool of readdirSync(join(prefix, 'usr/bin')).filter((name) => name.startsWith('wasm'))) {
    const lines = [
      '#!/bin/sh',
      'p="${0%/*}/../.."',
      `exec "$p/rt/usr/lib/${triplet}/${loader}" --library-path "$p/rt/usr/lib/${triplet}:$p/usr/lib/${triplet}" "$p/usr/bin/${tool}" "$@"`,
    ];
    writeFileSync(join(bin, tool), lines.join('\n') + '\n');
    chmodSync(join(bin, tool), 0o755);
  }
}

/** The configuration beside emcc.py, which Emscripten reads without any environment variable. */
function configure(prefix, place) {
  const file = join(prefix, 'usr/share/emscripten/.emscripten');
  const own = [
    'import shutil',
    `BINARYEN_ROOT = '${join(place, 'binaryen')}'`,
    "NODE_JS = shutil.which('node') or '/usr/bin/node'",
    "COMPILER_WRAPPER = shutil.which('ccache')",
  ];
  const kept = readFileSync(file, 'utf8').replace(/^(BINARYEN_ROOT|NODE_JS|CLOSURE_COMPILER)\b.*\n/gm, '');
  writeFileSync(file, kept + own.join('\n') + '\n');
}

/** Builds and runs a program with threads, a caught exception and SIMD flags: the features the page relies on. */
async function smokeTest(emscripten, folder, env) {
  const source = join(folder, 'smoke.cpp');
  const program = join(folder, 'smoke.cjs');
  writeFileSync(
    source,
    `#include <atomic>
#include <cstdio>
#include <stdexcept>
#include <thread>
int main() {
  std::atomic<int> sum{0};
  std::thread other([&] { try { throw std::runtime_error("x"); } catch (const std::exception&) { sum += 40; } });
  other.join();
  std::printf("%d\\n", sum.load() + 2);
}
`,
  );
  const flags = ['-O2', '-msimd128', '-pthread', '-fwasm-exceptions', '-sPROXY_TO_PTHREAD', '-sEXIT_RUNTIME'];
  await run('compiling a first program with Emscripten', join(emscripten, 'em++'), [...flags, source, '-o', program], {
    env,
  });
  const { text } = await run('running that program', process.execPath, [program], { timeout: 60000 });
  if (text.trim() !== '42') throw new Stop(`A program made with Emscripten printed '${text.trim()}' instead of 42.`);
}

async function compose(prefix, place) {
  const suite = await pinnedSuite();
  const arch = architecture();
  const pinned = Object.entries(pin.debs);
  const unsupported = pinned.find(([, deb]) => !deb.all && !deb[arch]);
  if (unsupported) {
    throw new Stop(`emsdk.lock pins no ${unsupported[0]} for ${arch}. ${officialAdvice()}`);
  }
  const names = pinned.map(([name, deb]) => `${name}=${deb.version}`);
  const debs = await suite.debs([...names, ...pin.debsOfAnyVersion]);
  pinned.forEach(([, deb], index) => verify(debs[index], deb.all ?? deb[arch]));
  for (const deb of debs) await run(`unpacking ${deb}`, 'dpkg', ['-x', deb, prefix]);
  for (const deb of await suite.debs(pin.runtimeDebsOfAnyVersion)) {
    await run(`unpacking ${deb}`, 'dpkg', ['-x', deb, join(prefix, 'rt')]);
  }
  const emscripten = join(prefix, 'usr/share/emscripten');
  for (const unused of [join(emscripten, 'test'), join(prefix, 'usr/share/doc'), join(prefix, 'usr/share/man')]) {
    rmSync(unused, { recursive: true, force: true });
  }
  mkdirSync(join(emscripten, 'node_modules'), { recursive: true });
  symlinkSync('../../nodejs/acorn', join(emscripten, 'node_modules/acorn'));
  wrapBinaryen(prefix);
  configure(prefix, place);
  const trial = join(prefix, 'trial');
  mkdirSync(trial);
  await smokeTest(emscripten, trial, { EM_BINARYEN_ROOT: join(prefix, 'binaryen') });
  rmSync(trial, { recursive: true });
}

function officialAdvice() {
  return (
    `With the official emsdk, \`./emsdk install ${pin.version} && ./emsdk activate ${pin.version}\` and ` +
    '`source ./emsdk_env.sh` provide the version this project pins; then run this command again.'
  );
}

/** The root folder of Emscripten at the pinned version; makes it if it can. */
export async function findEmscripten() {
  const found = installedRoot();
  if (found) return found;
  const { id, major } = release();
  if (id !== 'debian' || !(major >= 12)) {
    throw new Stop(`Emscripten ${pin.version} was not found. ${officialAdvice()}`);
  }
  if (major >= 13 && process.getuid() === 0) {
    say(`Emscripten ${pin.version}: installing it with apt-get (2 minutes)`);
    const env = { DEBIAN_FRONTEND: 'noninteractive' };
    // Another part of the set-up may hold the lock.
    const words = ['-o', 'DPkg::Lock::Timeout=900', 'install', '-y', '--no-install-recommends', 'emscripten'];
    await run('apt-get install emscripten', 'apt-get', words, { env, allowFailure: true });
    const root = installedRoot();
    if (root) return root;
  }
  const name = `emscripten-${pin.version}-${shortHash([pin, kRecipe, architecture()])}`;
  const prefix = await cached(
    name,
    { what: `Emscripten ${pin.version}`, howLong: 'a 250 MB download, about 1 minute' },
    compose,
  );
  return join(prefix, 'usr/share/emscripten');
}
