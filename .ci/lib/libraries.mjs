// The libraries the builds need, made once per user: headers, Dear ImGui sources, and zlib and OpenCV for WebAssembly.
import { cpSync, existsSync, mkdirSync, readdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { cached } from './cache.mjs';
import { OtherSuite } from './debian.mjs';
import { lock, shortHash } from './paths.mjs';
import { output, run, Stop } from './run.mjs';

const kRecipe = 1;
const flags = lock.wasmFlags;

async function unpackSource(folder, name) {
  const suite = await new OtherSuite(join(folder, 'apt'), lock.emscripten.debianSuite).open();
  const tarball = await suite.tarball(name, lock.sources[name]);
  const source = join(folder, 'source');
  mkdirSync(source);
  await run(`unpacking ${basename(tarball)}`, 'tar', ['-xf', tarball, '-C', source, '--strip-components=1']);
  rmSync(join(folder, 'apt'), { recursive: true });
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

async function zlib(emscripten) {
  const name = `zlib-wasm-${shortHash([lock.sources.zlib, lock.emscripten.version, flags, kRecipe])}`;
  return cached(name, { what: 'zlib for WebAssembly', howLong: '10 seconds' }, async (folder) => {
    const source = await unpackSource(folder, 'zlib');
    mkdirSync(join(folder, 'include'));
    mkdirSync(join(folder, 'lib'));
    const objects = join(folder, 'objects');
    mkdirSync(objects);
    for (const header of ['zlib.h', 'zconf.h']) cpSync(join(source, header), join(folder, 'include', header));
    // The gz* files are about files on disk, which this project never asks of zlib.
    const files = readdirSync(source).filter((file) => file.endsWith('.c') && !file.startsWith('gz'));
    const compile = ['-O3', ...flags.split(' '), '-c', ...files.map((file) => join(source, file))];
    await run('compiling zlib', join(emscripten, 'emcc'), compile, { cwd: objects });
    const parts = readdirSync(objects).map((file) => join(objects, file));
    await run('archiving zlib', join(emscripten, 'emar'), ['rcs', join(folder, 'lib/libz.a'), ...parts]);
    rmSync(objects, { recursive: true });
    rmSync(source, { recursive: true });
  });
}

const kOff = `BUILD_SHARED_LIBS BUILD_TESTS BUILD_PERF_TESTS BUILD_EXAMPLES BUILD_DOCS BUILD_JAVA BUILD_FAT_JAVA_LIB
  BUILD_opencv_apps BUILD_opencv_js BUILD_opencv_python3 BUILD_PACKAGE BUILD_ZLIB BUILD_WITH_DEBUG_INFO
  BUILD_IPP_IW BUILD_ITT BUILD_PROTOBUF CV_TRACE ENABLE_PIC OPENCV_GENERATE_PKGCONFIG OPENCV_GENERATE_SETUPVARS
  WITH_1394 WITH_ADE WITH_AVIF WITH_DIRECTX WITH_EIGEN WITH_FFMPEG WITH_FLATBUFFERS WITH_GSTREAMER WITH_GTK WITH_IMGCODEC_HDR
  WITH_IMGCODEC_PFM WITH_IMGCODEC_PXM WITH_IMGCODEC_SUNRASTER WITH_IPP WITH_ITT WITH_JASPER WITH_JPEG WITH_LAPACK
  WITH_OBSENSOR WITH_OPENCL WITH_OPENEXR WITH_OPENGL WITH_OPENJPEG WITH_OPENMP WITH_PNG WITH_PROTOBUF
  WITH_PTHREADS_PF WITH_QT WITH_QUIRC WITH_TBB WITH_TIFF WITH_V4L WITH_VTK WITH_VULKAN WITH_WEBP`.split(/\s+/);

async function opencv(emscripten, zlibFolder) {
  const key = shortHash([lock.sources.opencv, lock.emscripten.version, flags, kOff, zlibFolder, kRecipe]);
  const name = `opencv-${lock.sources.opencv.version}-wasm-${key}`;
  const what = {
    what: `OpenCV ${lock.sources.opencv.version} for WebAssembly`,
    howLong: 'a 78 MB download, 5 to 10 minutes on two cores',
  };
  return cached(name, what, async (folder) => {
    const source = await unpackSource(folder, 'opencv');
    const binary = join(folder, 'binary');
    const settings = {
      CMAKE_TOOLCHAIN_FILE: toolchainFile(emscripten),
      CMAKE_BUILD_TYPE: 'Release',
      CMAKE_C_FLAGS: flags,
      CMAKE_CXX_FLAGS: flags,
      CMAKE_INSTALL_PREFIX: folder,
      // Feature tests need to compile, not to link: linking each of them costs minutes.
      CMAKE_TRY_COMPILE_TARGET_TYPE: 'STATIC_LIBRARY',
      BUILD_LIST: 'core,imgproc',
      CV_ENABLE_INTRINSICS: 'ON',
      CPU_BASELINE: '',
      CPU_DISPATCH: '',
      ZLIB_INCLUDE_DIR: join(zlibFolder, 'include'),
      ZLIB_LIBRARY: join(zlibFolder, 'lib/libz.a'),
      ZLIB_LIBRARY_RELEASE: join(zlibFolder, 'lib/libz.a'),
      ...Object.fromEntries(kOff.map((option) => [option, 'OFF'])),
    };
    const defines = Object.entries(settings).map(([key, value]) => `-D${key}=${value}`);
    await run('configuring OpenCV (1 to 4 minutes)', 'cmake', ['-G', 'Ninja', '-S', source, '-B', binary, ...defines]);
    await run('compiling OpenCV (3 to 6 minutes)', 'cmake', ['--build', binary]);
    await run('installing OpenCV into the cache', 'cmake', ['--install', binary]);
    rmSync(binary, { recursive: true });
    rmSync(source, { recursive: true });
    if (!existsSync(join(folder, 'lib/libopencv_imgproc.a'))) throw new Stop('OpenCV was built but not installed.');
  });
}

export function toolchainFile(emscripten) {
  return join(emscripten, 'cmake/Modules/Platform/Emscripten.cmake');
}

/** Everything above, in order; the folders that build/deps.cmake names. */
export async function wasmLibraries(emscripten) {
  const zlibFolder = await zlib(emscripten);
  return { zlib: zlibFolder, opencv: await opencv(emscripten, zlibFolder) };
}
