// Debian packages: those this machine needs installed, and single files taken from a newer Debian without installing.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { cacheDir, lock } from './paths.mjs';
import { output, run, say, Stop } from './run.mjs';

/** `{id, codename, major}` of this machine; major is NaN where it is not a numbered release. */
export function release() {
  const text = existsSync('/etc/os-release') ? readFileSync('/etc/os-release', 'utf8') : '';
  const field = (key) => text.match(new RegExp(`^${key}="?([^"\n]*)"?$`, 'm'))?.[1] ?? '';
  return { id: field('ID'), codename: field('VERSION_CODENAME'), major: parseInt(field('VERSION_ID'), 10) };
}

function missing(packages) {
  const listed = output('sh', [
    '-c',
    `dpkg-query -W -f '\${Package} \${db:Status-Status}\\n' "$@" 2>/dev/null || true`,
    'sh',
    ...packages,
  ]);
  const installed = new Set(
    (listed ?? '')
      .split('\n')
      .filter((line) => line.endsWith(' installed'))
      .map((line) => line.split(' ')[0]),
  );
  return packages.filter((name) => !installed.has(name));
}

/** Installs what is missing of the lock's package groups; without root it says which command would. */
export async function installGroups(groups) {
  const wanted = [...new Set(groups.flatMap((group) => lock.debianPackages[group]))].sort();
  if (output('dpkg-query', ['--version']) === null) {
    throw new Stop(
      `This machine is not a Debian. Please install by hand the equivalents of: ${wanted.join(' ')}; ` +
        'the set-up itself knows Debian 12 and newer.',
    );
  }
  const absent = missing(wanted);
  if (!absent.length) return;
  const optional = missing(lock.debianPackagesIfOffered);
  if (process.getuid() !== 0) {
    throw new Stop(
      `Some Debian packages are missing. Please run:\n  sudo apt-get install --no-install-recommends ${absent.join(' ')}`,
    );
  }
  await install(absent, optional);
}

/** Installs what may be missing: where it cannot be had, what asks for it is told as not there. */
export async function installIfPossible(group) {
  if (output('dpkg-query', ['--version']) === null) return;
  const absent = missing(lock.debianPackages[group]);
  if (!absent.length) return;
  if (process.getuid() === 0) await install([], absent);
  else
    say(
      `Tests that need ${absent.join(', ')} are skipped. To run them: sudo apt-get install --no-install-recommends ${absent.join(' ')}`,
    );
}

async function install(required, optional) {
  say(`Debian packages: installing ${[...required, ...optional].join(' ')} (1 to 3 minutes)`);
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  const patient = ['-o', 'DPkg::Lock::Timeout=900', '-o', 'Acquire::Retries=3'],
    words = [...patient, 'install', '-y', '--no-install-recommends'];
  await run('apt-get update', 'apt-get', [...patient, 'update'], { env });
  if (required.length) await run('apt-get install', 'apt-get', [...words, ...required], { env });
  for (const name of optional) {
    await run(`apt-get install ${name}`, 'apt-get', [...words, name], { env, allowFailure: true });
  }
}

/** The address and keyring of the machine's own Debian, from its apt sources (either format). */
export function ownDebianSource(codename, folder = '/etc/apt') {
  const own = new Set([codename, 'stable', 'oldstable']);
  const parts = join(folder, 'sources.list.d');
  const files = existsSync(parts)
    ? readdirSync(parts)
        .sort()
        .map((name) => join(parts, name))
    : [];
  const texts = [join(folder, 'sources.list'), ...files]
    .filter((file) => existsSync(file) && /\.(list|sources)$/.test(file))
    .map((file) => readFileSync(file, 'utf8').replace(/^#.*\n?/gm, ''));
  for (const text of texts) {
    for (const block of text.split(/\n\s*\n/)) {
      const field = (key) => block.match(new RegExp(`^${key}:[ \\t]*(.+)$`, 'mi'))?.[1].trim() ?? '';
      if (!field('Types').split(/\s+/).includes('deb')) continue;
      if (
        !field('Suites')
          .split(/\s+/)
          .some((suite) => own.has(suite))
      )
        continue;
      return { uri: field('URIs').split(/\s+/)[0], signedBy: field('Signed-By') };
    }
    for (const line of text.split('\n')) {
      const hit = line.match(/^\s*deb\s+(?:\[([^\]]*)\]\s+)?(\S+)\s+(\S+)\s+/);
      if (!hit || !own.has(hit[3])) continue;
      return { uri: hit[2], signedBy: hit[1]?.match(/signed-by=(\S+)/)?.[1] ?? '' };
    }
  }
  throw new Stop(`No Debian source for ${codename} was found in ${folder}/sources.list or ${parts}.`);
}

/**
 * A private view of another Debian suite at the machine's own Debian address, in `folder`.
 * The machine's package lists and its installed packages are not touched.
 */
export class OtherSuite {
  constructor(folder, suite) {
    this.folder = folder;
    this.suite = suite;
    this.env = { APT_CONFIG: join(folder, 'apt.conf') };
  }

  async open() {
    for (const name of ['lists/partial', 'archives/partial', 'parts', 'files']) {
      mkdirSync(join(this.folder, name), { recursive: true });
    }
    const { uri, signedBy } = ownDebianSource(release().codename);
    const source = ['Types: deb deb-src', `URIs: ${uri}`, `Suites: ${this.suite}`, 'Components: main'];
    if (signedBy) source.push(`Signed-By: ${signedBy}`);
    writeFileSync(join(this.folder, 'parts', `${this.suite}.sources`), source.join('\n') + '\n');
    const conf = {
      'Dir::State::Lists': join(this.folder, 'lists'),
      'Dir::Etc::SourceList': '/dev/null',
      'Dir::Etc::SourceParts': join(this.folder, 'parts'),
      'Dir::Cache::Archives': join(this.folder, 'archives'),
      'Dir::Cache::pkgcache': '',
      'Dir::Cache::srcpkgcache': '',
      'Acquire::Retries': '3',
      'APT::Sandbox::User': 'root',
      'Acquire::Languages': 'none',
    };
    const lines = Object.entries(conf).map(([key, value]) => `${key} "${value}";`);
    writeFileSync(this.env.APT_CONFIG, lines.join('\n') + '\n');
    await run(`reading the package lists of Debian ${this.suite}`, 'apt-get', ['update'], { env: this.env });
    return this;
  }

  /** Downloads binary packages (`name` or `name=version`) and returns their files in the same order. */
  async debs(names) {
    const files = join(this.folder, 'files');
    await run(`downloading ${names.join(' ')}`, 'apt-get', ['download', ...names], { env: this.env, cwd: files });
    const have = readdirSync(files);
    return names.map((name) => {
      const bare = name.split('=')[0];
      return join(
        files,
        have.find((file) => file.startsWith(`${bare}_`) && file.endsWith('.deb')),
      );
    });
  }

  /** Downloads the upstream tarball of a source package as the lock names it. */
  async tarball(name, { file, sha256 }) {
    const listed = output('apt-get', ['source', '--print-uris', '--download-only', name], {
      env: { ...process.env, ...this.env },
      cwd: join(this.folder, 'files'),
    });
    const uri = (listed ?? '')
      .split('\n')
      .map((line) => line.match(/^'([^']+)'\s+(\S+)/))
      .find((hit) => hit && decodeURIComponent(hit[2]) === file)?.[1];
    if (!uri) throw new Stop(`Debian ${this.suite} no longer offers ${file}, which emsdk.lock pins.`);
    const to = join(this.folder, 'files', file);
    await run(`downloading ${file}`, '/usr/lib/apt/apt-helper', ['download-file', uri, to, `SHA256:${sha256}`], {
      env: this.env,
    });
    verify(to, sha256);
    return to;
  }
}

let pinned = null;

/** The suite that the lock names, opened once for a whole set-up; closePinnedSuite removes what it downloaded. */
export function pinnedSuite() {
  const folder = () => mkdtempSync(join(cacheDir, '.making-apt-'));
  pinned ??= new OtherSuite(folder(), lock.emscripten.debianSuite);
  return (pinned.opening ??= pinned.open());
}

export function closePinnedSuite() {
  if (pinned) rmSync(pinned.folder, { recursive: true, force: true });
  pinned = null;
}

/** Throws Stop unless the file's SHA-256 is the pinned one. */
export function verify(file, sha256) {
  const found = createHash('sha256').update(readFileSync(file)).digest('hex');
  if (found !== sha256) throw new Stop(`${file} has SHA-256 ${found}, but emsdk.lock pins ${sha256}.`);
}
