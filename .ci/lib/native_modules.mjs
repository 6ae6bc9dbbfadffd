// The npm package that has C++ in it, compiled for this Node: better-sqlite3, the store of the share server. Its own
// installer would fetch a binary from elsewhere; here it is compiled from the package, once for this user.
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { cached } from './cache.mjs';
import { installGroups } from './debian.mjs';
import { root, shortHash } from './paths.mjs';
import { output, run, Stop } from './run.mjs';

const kPackage = 'better-sqlite3';
const kBinary = 'build/Release/better_sqlite3.node';

/** The folder above include/node with the headers of this very Node's version; null where there is none. */
function headersOfNode() {
  const [major] = process.versions.node.split('.');
  const places = [dirname(dirname(process.execPath)), '/usr', '/usr/local'];
  const isOurs = (place) => {
    const file = join(place, 'include/node/node_version.h');
    return existsSync(file) && readFileSync(file, 'utf8').includes(`#define NODE_MAJOR_VERSION ${major}\n`);
  };
  return places.find(isOurs) ?? null;
}

/** node-gyp comes with npm; Debian has it as a package of its own, which its npm needs. */
function nodeGyp() {
  const places = [join(output('npm', ['root', '-g']) ?? '', 'npm/node_modules'), '/usr/share/nodejs'];
  const found = places.map((place) => join(place, 'node-gyp/bin/node-gyp.js')).find((file) => existsSync(file));
  if (!found) throw new Stop('node-gyp, which comes with npm, was not found; please install npm.');
  return found;
}

/** Compiles the package, which npm has put there, on one core. */
export async function compileNativeModules() {
  const from = join(root, 'node_modules', kPackage);
  const binary = join(from, kBinary);
  if (existsSync(binary)) return;
  const { version } = JSON.parse(readFileSync(join(from, 'package.json'), 'utf8'));
  const name = `${kPackage}-${version}-${shortHash([process.versions.modules, process.arch])}`;
  const place = await cached(name, { what: `${kPackage} ${version}`, howLong: '1 to 3 minutes' }, async (temporary) => {
    if (!headersOfNode()) await installGroups(['nodeHeaders']);
    const headers = headersOfNode();
    if (!headers)
      throw new Stop(`The headers of Node ${process.versions.node} are missing: Debian has them as libnode-dev.`);
    const work = join(temporary, 'work');
    cpSync(from, work, { recursive: true });
    const args = [nodeGyp(), 'rebuild', '--release', `--nodedir=${headers}`];
    await run(`compiling ${kPackage}`, process.execPath, args, { cwd: work });
    cpSync(join(work, kBinary), join(temporary, basename(kBinary)));
    rmSync(work, { recursive: true });
  });
  mkdirSync(dirname(binary), { recursive: true });
  cpSync(join(place, basename(kBinary)), binary);
}
