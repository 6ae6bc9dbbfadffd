// A PostgreSQL of the tests' own: a temporary cluster on a socket in its folder, which no other program reaches.
import { spawnSync } from 'node:child_process';
import { chownSync, existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** The folder with Debian's programs, of the newest version; null where there is none. */
export function postgresPrograms(folder = '/usr/lib/postgresql') {
  if (!existsSync(folder)) return null;
  const places = readdirSync(folder)
    .sort((a, b) => Number(b) - Number(a))
    .map((version) => join(folder, version, 'bin'));
  return places.find((place) => existsSync(join(place, 'initdb'))) ?? null;
}

/** PostgreSQL refuses to run as root: there it runs as the user of its package. */
function otherUser() {
  if (process.getuid() !== 0) return {};
  const number = (flag) => Number(spawnSync('id', [flag, 'postgres'], { encoding: 'utf8' }).stdout);
  return { uid: number('-u'), gid: number('-g') };
}

/** Starts a cluster; `address(name)` makes a new database in it, `close` ends it and removes it. */
export function startPostgres() {
  const programs = postgresPrograms();
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-pg-'));
  const user = otherUser();
  if (user.uid !== undefined) chownSync(folder, user.uid, user.gid);
  const program = (name, args) => {
    const done = spawnSync(join(programs, name), args, { ...user, cwd: folder, encoding: 'utf8', timeout: 120_000 });
    if (done.status !== 0) throw new Error(`${name}: ${done.stderr || done.stdout || done.error}`);
  };
  const data = join(folder, 'data');
  const owner = ['-h', folder, '-U', 'spineloft'];
  program('initdb', ['-D', data, '-U', 'spineloft', '-A', 'trust', '-E', 'UTF8', '--no-locale', '--no-sync']);
  const options = `-c listen_addresses='' -c unix_socket_directories='${folder}' -c max_connections=120`;
  program('pg_ctl', ['-D', data, '-w', '-t', '60', '-l', join(folder, 'log'), '-o', options, 'start']);
  const url = (name) => `postgres://spineloft@localhost/${name}?host=${encodeURIComponent(folder)}`;
  return {
    programs,
    address(name) {
      program('createdb', [...owner, name]);
      return url(name);
    },
    close() {
      program('pg_ctl', ['-D', data, '-w', '-m', 'immediate', 'stop']);
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
