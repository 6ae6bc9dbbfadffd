// The libraries the builds need, made once per user: headers, Dear ImGui sources, and OpenCV for WebAssembly.
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { cached } from './cache.mjs';
import { pinnedSuite } from './debian.mjs';
import { cacheDir, lock, root, shortHash } from './paths.mjs';
import { output, run, Stop } from './run.mjs';

const kRecipe = 1;
const flags = lock.wasmFlags;

/** The pinned source of `name`, or those `parts` of it, in a folder within `folder`. */
async function unpackSource(folder, name, parts = []) {
  const suite = await pinnedSuite();
  const tarball = await suite.tarball(name, lock.sources[name]);
  const source = join(folder, 'source');
  mkdirSync(source);
  const wanted = parts.length ? ['--wildcards', ...parts.map((part) => `*/${part}/*`)] : [];
  await run(`unpacking ${basename(tarball)}`, 'tar', ['-xf', tarball, '-C', source, '--strip-components=1', ...wanted]);
  return source;
}

/**
 * What the compilers get from the machine's headers: exactly these, since the wasm one must never see the whole of
 * /usr/include. stb comes from its pinned source instead: Debian 12's stb_image 2.27 overruns a table on hostile JPEGs.
 */
const kHeaders = {
  'doctest-dev': [['/usr/include/doctest', 'doctest']],
  'libeigen3-dev': [
    ['/usr/include/eigen3/Eigen', 'Eigen'],
    ['/usr/include/eigen3/unsupported', 'unsupported'],
  ],
  'libtinygltf-dev': [['/usr/include/tiny_gltf.h', 'tiny_gltf.h']],
  'nlohmann-json3-dev': [['/usr/include/nlohmann', 'nlohmann']],
};

export async function headers() {
  const versions = output('dpkg-query', ['-W', ...Object.keys(kHeaders)]);
  if (versions === null) throw new Stop(`These Debian packages are needed: ${Object.keys(kHeaders).join(' ')}.`);
  const what = { what: 'Header-only libraries', howLong: 'seconds' };
  const key = shortHash([versions, kHeaders, lock.sources.libstb, kRecipe]);
  return cached(`headers-${key}`, what, async (folder) => {
    const stb = await unpackSource(folder, 'libstb');
    for (const name of readdirSync(stb).filter((file) => /^stb_.*\.h$/.test(file))) {
      cpSync(join(stb, name), join(folder, name));
      cpSync(join(stb, name), join(folder, 'stb', name));
    }
    rmSync(stb, { recursive: true });
    for (const [from, to] of Object.values(kHeaders).flat()) {
      cpSync(from, join(folder, to), { recursive: true, dereference: true });
    }
  });
}

export async function imguiSources() {
  const name = `imgui-${lock.sources.imgui.version}-${shortHash([lock.sources.imgui, kRecipe])}`;
  return cached(name, { what: 'Dear ImGui', howLong: 'seconds' }, async (folder) => {
    const source = await unpackSource(folder, 'imgui');
    const keep = readdirSync(source).filter((file) => /\.(cpp|h|txt)$/.test(file));
    for (const file of keep) cpSync(join(source, file), join(folder, file));
    mkdirSync(join(folder, 'backends'));
    for (const file of readdirSync(join(source, 'backends')).filter((name) => /_(glfw|opengl3)/.test(name))) {
      cpSync(join(source, 'backends', file), join(folder, 'backends', file));
    }
    cpSync(join(source, 'misc'), join(folder, 'misc'), { recursive: true });
    rmSync(source, { recursive: true });
  });
}

const kOpencvProject = join(root, '.ci/opencv');

function opencvName() {
  const recipe = readFileSync(join(kOpencvProject, 'CMakeLists.txt'), 'utf8');
  const key = shortHash([lock.sources.opencv, lock.emscripten.version, flags, recipe, kRecipe]);
  return `opencv-${lock.sources.opencv.version}-wasm-${key}`;
}

/** Where OpenCV for WebAssembly is once it is made. */
export const opencvFolder = join(cacheDir, opencvName());

/** OpenCV as .ci/opencv/CMakeLists.txt makes it: what the cut-outs reach. */
export async function makeOpencv(emscripten) {
  const what = {
    what: `OpenCV ${lock.sources.opencv.version} for WebAssembly`,
    howLong: 'a 78 MB download, about 1 minute on two cores',
  };
  return cached(opencvName(), what, async (folder) => {
    const source = await unpackSource(folder, 'opencv', ['modules/core', 'modules/imgproc']);
    const binary = join(folder, 'binary');
    const settings = {
      CMAKE_TOOLCHAIN_FILE: toolchainFile(emscripten),
      CMAKE_CXX_FLAGS: flags,
      CMAKE_INSTALL_PREFIX: folder,
      SPINELOFT_OPENCV_SOURCE: source,
    };
    const defines = Object.entries(settings).map(([key, value]) => `-D${key}=${value}`);
    await run('configuring OpenCV', 'cmake', ['-G', 'Ninja', '-S', kOpencvProject, '-B', binary, ...defines]);
    await run('compiling OpenCV', 'cmake', ['--build', binary]);
    await run('installing OpenCV into the cache', 'cmake', ['--install', binary]);
    rmSync(binary, { recursive: true });
    rmSync(source, { recursive: true });
  });
}

export function toolchainFile(emscripten) {
  return join(emscripten, 'cmake/Modules/Platform/Emscripten.cmake');
}
