// Putting the static site together: hashed names, relative addresses, compressed twins, swapped into dist/ at the end.
import { createHash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, extname, join, relative } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, gzip } from 'node:zlib';
import { presetDir } from './cmake.mjs';
import { iconFont, scriptFont, scriptLanguages, textFont } from './fonts.mjs';
import { checkLicences } from './licences.mjs';
import { buildDir, distDir, root, shortHash } from './paths.mjs';
import { Stop } from './run.mjs';

const kHashLength = 10;
// Files that shrink; pictures and the like are packed already.
const kCompressed = new Set(['.html', '.js', '.css', '.wasm', '.json', '.svg', '.ttf', '.txt', '.md', '.webmanifest']);
const kSmallestCompressed = 1024;

const makers = { br: promisify(brotliCompress), gz: (bytes) => promisify(gzip)(bytes, { level: 9 }) };

function contentHash(bytes) {
  return createHash('sha256').update(bytes).digest('hex').slice(0, kHashLength);
}

function hashedName(name, bytes) {
  const extension = extname(name);
  return `${name.slice(0, name.length - extension.length)}-${contentHash(bytes)}${extension}`;
}

/** All files under a folder, as paths from it, sorted. */
export function filesUnder(folder, at = folder) {
  if (!existsSync(at)) return [];
  const found = readdirSync(at).flatMap((name) => {
    const file = join(at, name);
    return statSync(file).isDirectory() ? filesUnder(folder, file) : [relative(folder, file)];
  });
  return found.sort();
}

function put(folder, name, bytes) {
  const file = join(folder, name);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, bytes);
  return name;
}

/** The name of an engine's second program in its loader: web/platform/second_program.js. */
const kSecond = 'spineloft_second.wasm';

function replaceName(text, from, to) {
  const parts = text.split(new RegExp(`(?<=["'\`/])${from.replace('.', '\\.')}(?=["'\`])`));
  if (parts.length < 2)
    throw new Stop(`The Emscripten loader no longer names ${from}; .ci/lib/site.mjs must learn its new form.`);
  return parts.join(to);
}

/** The programs of the page's two engines. */
const kEngines = { threads: 'spineloft_web', single: 'spineloft_web_single' };

/** The parts of a site that it can be put together without: its engines, one of which is needed, and the search for cut-outs. */
export const siteParts = [...Object.keys(kEngines), 'cutOut'];

/** What CMake builds for a site with these parts. */
export const siteTargets = (parts = siteParts) => [
  'spineloft_self_crossing',
  ...parts.map((part) => kEngines[part] ?? 'spineloft_cut_out'),
];

/** Where a page asks for a part that was not linked when the page was put together; the server lets it wait. */
export const laterPath = (part) => `assets/spineloft-${part}-later`;

/** Where CMake puts what it links for the page. */
const kLinked = join(presetDir('wasm-release'), 'web');

/** Copies a file that was built to the assets under a hashed name. */
function putBuilt(folder, file, as) {
  if (!existsSync(file)) throw new Stop(`${basename(file)} is not built.`);
  const bytes = readFileSync(file);
  return put(folder, join('assets', hashedName(as, bytes)), bytes);
}

/** Copies one engine under hashed names; the loader's own references follow. Returns the loader's path. */
function putEngine(folder, engine) {
  const name = kEngines[engine];
  const wasm = putBuilt(folder, join(kLinked, `${name}.wasm`), `spineloft-${engine}.wasm`);
  const second = putBuilt(folder, join(kLinked, `${name}_second.wasm`), `spineloft-${engine}-second.wasm`);
  const named = replaceName(readFileSync(join(kLinked, `${name}.js`), 'utf8'), `${name}.wasm`, basename(wasm));
  const loader = replaceName(named, kSecond, basename(second));
  const loaderName = hashedName(`spineloft-${engine}.js`, loader);
  return { js: put(folder, `assets/${loaderName}`, loader), wasm, second };
}

/** The licences keep their names: they are looked for by them. */
const kNamed = new Set(['.md', '.txt']);

/** Copies assets/ (but what only the README shows) under hashed names; a map from `samples/cup.jpg` to `assets/samples/cup-0123456789.jpg`. */
function putAssets(folder) {
  const from = join(root, 'assets');
  const map = {};
  for (const path of filesUnder(from).filter((name) => !name.startsWith('docs/'))) {
    const bytes = readFileSync(join(from, path));
    map[path] = put(folder, join('assets', kNamed.has(extname(path)) ? path : hashedName(path, bytes)), bytes);
  }
  return map;
}

/** The fonts of scripts that Inter lacks, by language. */
async function putScripts(folder) {
  const scripts = {};
  for (const id of scriptLanguages) {
    const [text, bold] = await Promise.all(['text', 'bold'].map((weight) => scriptFont(id, weight)));
    const place = (name, bytes) => put(folder, join('assets', hashedName(`script-${id}-${name}.ttf`, bytes)), bytes);
    scripts[id] = { text: place('text', text), bold: place('bold', bold) };
  }
  return scripts;
}

/** Imported fonts bring only the letters and icons that the page draws. */
const smallFonts = {
  name: 'small-fonts',
  setup(build) {
    const load = (filter, font) =>
      build.onLoad({ filter }, async ({ path }) => ({ contents: await font(path), loader: 'file' }));
    load(/lucide\.ttf$/, iconFont);
    load(/Inter_\w+\.ttf$/, textFont);
  },
};

/** CSS pixels of text at the usual size; web/shell/text_size.ts is the same for the canvas. */
const kUsualText = 16;

/**
 * A style sheet whose pixels are those at the usual size of text: they become shares of the size that the browser asks for,
 * and the widths at which the page is laid out differently follow it, so that large text is like a zoomed page.
 */
export function followingText(css) {
  const shares = (text, unit) =>
    text.replace(/(?<![\w#.])(\d*\.?\d+)px\b/g, (whole, pixels) => `${Number(pixels) / kUsualText}${unit}`);
  return css
    .split(/(@media[^{]*)/)
    .map((piece) => shares(piece, piece.startsWith('@media') ? 'em' : 'rem'))
    .join('');
}

const sheetsThatFollow = {
  name: 'sheets-that-follow-text',
  setup(build) {
    build.onLoad({ filter: /web[\\/]shell[\\/].*\.css$/ }, ({ path }) => ({
      contents: followingText(readFileSync(path, 'utf8')),
      loader: 'css',
    }));
  },
};

/** The engine's test for meshes that go through themselves, which the worker of solids loads. */
export const selfCrossingFile = join(kLinked, 'spineloft_self_crossing.wasm');
/** What the worker that cuts out loads. */
export const cutOutFile = join(kLinked, 'spineloft_cut_out.wasm');

/** Bundles the entry points; the files that were read are added to `read`. */
async function bundle(folder, read, entryPoints, define, place = { outdir: 'assets', entryNames: '[name]-[hash]' }) {
  const esbuild = await import('esbuild');
  const result = await esbuild
    .build({
      absWorkingDir: root,
      entryPoints,
      bundle: true,
      format: 'esm',
      target: 'es2022',
      minify: true,
      metafile: true,
      legalComments: 'none',
      logLevel: 'silent',
      outdir: join(folder, place.outdir),
      entryNames: place.entryNames,
      assetNames: '[name]-[hash]',
      loader: {
        '.svg': 'text',
        '.ttf': 'file',
        '.woff2': 'file',
        '.png': 'file',
        '.jpg': 'file',
        '.webp': 'file',
        '.wasm': 'file',
        '.glsl': 'text',
      },
      define: { 'process.env.NODE_ENV': '"production"', ...define },
      alias: { 'spineloft/self_crossing.wasm': selfCrossingFile },
      // manifold-3d asks for it where it runs in Node alone.
      external: ['node:module'],
      plugins: [smallFonts, sheetsThatFollow],
    })
    .catch((error) => {
      const lines = (error.errors ?? []).map((e) => `${e.location?.file}:${e.location?.line}: ${e.text}`);
      throw new Stop(`esbuild failed:\n${lines.join('\n') || error.message}`);
    });
  read.push(...Object.keys(result.metafile.inputs));
  const outputs = {};
  for (const [file, about] of Object.entries(result.metafile.outputs)) {
    if (!about.entryPoint) continue;
    outputs[relative('web/shell', about.entryPoint)] = {
      js: relative(folder, join(root, file)),
      css: about.cssBundle && relative(folder, join(root, about.cssBundle)),
    };
  }
  return outputs;
}

/** Copies the web app's manifest, its icons under their hashed names. */
function putManifest(folder, text, assets) {
  const linked = text.replace(/"assets\/([^"]+)"/g, (whole, path) => {
    if (!assets[path]) throw new Stop(`${kManifest} names assets/${path}, which does not exist.`);
    return `"${assets[path]}"`;
  });
  put(folder, kManifest, linked);
}

/** The names of the web app's manifest and of the service worker, beside index.html; the modules of other languages and of what uses a server. */
const kManifest = 'site.webmanifest';
const kSpeaker = 'web/shell/words/speaker.ts';
/** What the viewer loads when it needs it. */
const kViewerModules = ['derive', 'room'];
const kServerSide = 'web/shell/room/server_side.ts';
const kServiceWorker = 'service_worker.js';

/** Whether the host has a share server: `npm start` answers for this file while it has one. Never stored. */
const kShareInfo = 'share.json';

/** Every file of the site as the service worker stores it: what all pages need, what each engine's do, and what few do. */
function filesToStore(folder, { threads, single, viewer }) {
  const apart = {
    ...Object.fromEntries(
      Object.entries({ threads, single }).map(([name, { js, wasm, second }]) => [name, [js, wasm, second]]),
    ),
    rare: [viewer.room],
  };
  const entry = (path) => {
    const bytes = readFileSync(join(folder, path));
    if (/-([0-9A-Z]{8}|[0-9a-f]{10})\.[a-z0-9]+$/.test(path)) return { url: path, revision: null };
    // A release that is put in place while this one is being stored is refused by its sum.
    const integrity = `sha256-${createHash('sha256').update(bytes).digest('base64')}`;
    return { url: path, revision: contentHash(bytes), integrity };
  };
  const isApart = new Set(Object.values(apart).flat());
  return {
    page: filesUnder(folder)
      .filter((path) => !isApart.has(path) && path !== kShareInfo)
      .map(entry),
    ...Object.fromEntries(Object.entries(apart).map(([name, paths]) => [name, paths.map(entry)])),
  };
}

/** A page of web/shell with its script, style sheet and asset links under their hashed names. */
function page(path, main, assets) {
  const html = readFileSync(join(root, 'web/shell', path), 'utf8');
  let text = html.replace(/(<script type="module" src=)"\.\/\w+\.ts"/, `$1"./${main.js}"`);
  if (text === html) throw new Stop(`web/shell/${path} must load its script as a module.`);
  if (main.css) text = text.replace('</head>', `  <link rel="stylesheet" href="./${main.css}">\n</head>`);
  return text.replace(/(href|src|content)="(?:\.\.\/)+assets\/([^"]+)"/g, (whole, attribute, path) => {
    if (!assets[path]) throw new Stop(`A page names assets/${path}, which does not exist.`);
    return `${attribute}="./${assets[path]}"`;
  });
}

/** Compressed twins beside each file; they are kept by content, since brotli at its best takes seconds. */
async function compress(folder) {
  const store = join(buildDir, 'compressed');
  mkdirSync(store, { recursive: true });
  const used = new Set();
  const jobs = filesUnder(folder).flatMap((path) => {
    const bytes = readFileSync(join(folder, path));
    if (!kCompressed.has(extname(path)) || bytes.length < kSmallestCompressed) return [];
    return Object.entries(makers).map(async ([kind, make]) => {
      const name = `${contentHash(bytes)}-${bytes.length}.${kind}`;
      const kept = join(store, name);
      used.add(name);
      if (!existsSync(kept)) {
        const unfinished = `${kept}.${process.pid}`;
        writeFileSync(unfinished, await make(bytes));
        renameSync(unfinished, kept);
      }
      cpSync(kept, join(folder, `${path}.${kind}`));
    });
  });
  await Promise.all(jobs);
  for (const name of readdirSync(store)) if (!used.has(name)) rmSync(join(store, name));
}

/** Sizes of the wasm files and scripts of a site: raw, gzip, brotli. */
export function siteSizes(folder = distDir) {
  const size = (file) => (existsSync(file) ? statSync(file).size : null);
  return filesUnder(join(folder, 'assets'))
    .filter((path) => /\.(wasm|js|css)$/.test(path))
    .map((path) => {
      const file = join(folder, 'assets', path);
      return { file: basename(path), raw: size(file), gzip: size(`${file}.gz`), brotli: size(`${file}.br`) };
    });
}

/**
 * Assembles dist/ from those of its `parts` that are linked, web/shell and assets/; the old site stays until the new one
 * is whole. With `keep` its files stay in the new one too, for pages that are open; `twins`: with compressed ones. Returns
 * what the page is told of the site.
 */
export async function assembleSite({ parts = siteParts, keep = false, twins = true } = {}) {
  const shell = join(root, 'web/shell');
  const fresh = join(buildDir, 'site');
  rmSync(fresh, { recursive: true, force: true });
  mkdirSync(fresh, { recursive: true });
  const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const assets = putAssets(fresh);
  const isWhole = parts.length === siteParts.length;
  const site = {
    version,
    ...Object.fromEntries(
      Object.keys(kEngines).map((engine) => [
        engine,
        parts.includes(engine) ? putEngine(fresh, engine) : { js: laterPath(engine), wasm: '', second: '' },
      ]),
    ),
    cutOut: parts.includes('cutOut') ? putBuilt(fresh, cutOutFile, 'spineloft_cut_out.wasm') : laterPath('cutOut'),
    assets,
    workers: {},
    speaker: '',
    viewer: {},
    serverSide: '',
    scripts: await putScripts(fresh),
    // A site with a part to come is not worth storing.
    serviceWorker: isWhole ? kServiceWorker : '',
  };
  const read = [];
  const workers = readdirSync(shell).filter((name) => name.endsWith('.worker.ts'));
  if (workers.length) {
    const built = await bundle(
      fresh,
      read,
      workers.map((name) => `web/shell/${name}`),
      { SPINELOFT_SITE: JSON.stringify(site) },
    );
    for (const [entry, files] of Object.entries(built)) site.workers[entry.replace(/\.worker\.ts$/, '')] = files.js;
  }
  site.serverSide = (await bundle(fresh, read, [kServerSide], {}))[relative('web/shell', kServerSide)].js;
  site.speaker = (await bundle(fresh, read, [kSpeaker], {}))[relative('web/shell', kSpeaker)].js;
  const modules = await bundle(
    fresh,
    read,
    kViewerModules.map((name) => `web/shell/view/${name}.ts`),
    { SPINELOFT_SITE: JSON.stringify(site) },
  );
  for (const name of kViewerModules) site.viewer[name] = modules[`view/${name}.ts`].js;
  const built = await bundle(fresh, read, ['web/shell/main.ts', 'web/shell/view/view.ts'], {
    SPINELOFT_SITE: JSON.stringify(site),
  });
  put(fresh, kShareInfo, '{"server": null}\n');
  put(fresh, 'index.html', page('index.html', built['main.ts'], assets));
  put(fresh, 'view.html', page('view/view.html', built['view/view.ts'], assets));
  putManifest(fresh, readFileSync(join(shell, kManifest), 'utf8'), assets);
  if (isWhole) {
    const files = filesToStore(fresh, site);
    const define = { SPINELOFT_FILES: JSON.stringify(files) };
    await bundle(fresh, read, ['web/shell/offline/service_worker.ts'], define, { outdir: '.', entryNames: '[name]' });
  }
  const engines = parts.filter((part) => kEngines[part]);
  checkLicences(['spineloft_cut_out.wasm', ...engines.map((engine) => `${kEngines[engine]}.js`)], read);
  if (twins) await compress(fresh);
  if (keep && existsSync(distDir)) cpSync(distDir, fresh, { recursive: true, force: false });
  const old = join(buildDir, `site-old-${shortHash(Date.now())}`);
  if (existsSync(distDir)) renameSync(distDir, old);
  renameSync(fresh, distDir);
  rmSync(old, { recursive: true, force: true });
  return site;
}
