// Both stores for tests that state what either must do; each test has one of its own.
import { randomBytes } from 'node:crypto';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openStore } from '../../../web/share/store.mjs';
import { postgresPrograms, startPostgres } from './postgres.mjs';

let number = 0;

/**
 * `open()` gives a new empty store, `again()` another one on the same data, as a second server has it; `place()` the
 * address of a store that is not there yet.
 */
function kitOf(name, { place, close = () => undefined }) {
  let address;
  return {
    name,
    place,
    async open(options) {
      address = place();
      return openStore(address, options);
    },
    again: (options) => openStore(address, options),
    address: () => address,
    close,
  };
}

export function sqliteKit() {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-store-'));
  return kitOf('SQLite', {
    place: () => join(folder, `${(number += 1)}.sqlite`),
    close: () => rmSync(folder, { recursive: true, force: true }),
  });
}

export function postgresKit() {
  const cluster = startPostgres();
  return kitOf('PostgreSQL', {
    place: () => cluster.address(`store_${(number += 1)}`),
    close: () => cluster.close(),
  });
}

/** By name, and what makes each; PostgreSQL where it is installed. */
export const kStoreKits = [
  { name: 'SQLite', make: sqliteKit, skip: false },
  { name: 'PostgreSQL', make: postgresKit, skip: postgresPrograms() ? false : 'PostgreSQL is not installed' },
];

export const id = () => {
  const bytes = randomBytes(16);
  return bytes.toString('base64url');
};
export const hash = () => randomBytes(32);
