// npm start -- --https on a school's own network: the certificate of this run names the addresses that pupils type, and
// the page has what browsers give over https only.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { networkInterfaces, tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { connect } from 'node:tls';
import { openPage } from '../../.ci/lib/browser.mjs';
import { root } from '../../.ci/lib/paths.mjs';
import { kLight, kWindow, useSite } from './support/page.mjs';

const kit = useSite();

const networkAddress = Object.values(networkInterfaces())
  .flat()
  .find(({ family, internal }) => family === 'IPv4' && !internal)?.address;

/** Starts the site that is built; `addresses` are those that it prints. */
async function start(t, ...options) {
  const folder = mkdtempSync(join(tmpdir(), 'spineloft-https-'));
  const store = ['--store', join(folder, 'share.sqlite')];
  const child = spawn(process.execPath, ['.ci/start.mjs', '--no-build', '--port', '0', ...store, ...options], {
    cwd: root,
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  t.after(async () => {
    const ended = new Promise((resolve) => child.once('exit', resolve));
    child.kill('SIGTERM');
    await ended;
    rmSync(folder, { recursive: true, force: true });
  });
  let said = '';
  for await (const chunk of child.stdout) {
    said += chunk;
    if (/Ctrl-C ends it/.test(said)) break;
  }
  return said.match(/https?:\/\/\S+/g);
}

const namesOf = ({ hostname, port }) =>
  new Promise((resolve, reject) => {
    const socket = connect({ host: hostname, port, rejectUnauthorized: false }, () => {
      resolve(socket.getPeerCertificate().subjectaltname);
      socket.destroy();
    });
    socket.on('error', reject);
  });

test(
  'with --https the page on a network address is a secure one with threads and a class',
  { skip: networkAddress ? false : 'no network' },
  async (t) => {
    const addresses = await start(t, '--host', '0.0.0.0', '--https');
    const address = addresses.find((one) => one.includes(networkAddress));
    assert.ok(address?.startsWith('https://'), addresses.join());
    assert.match(await namesOf(new URL(address)), new RegExp(`DNS:localhost.*IP Address:${networkAddress}`));
    const options = { viewport: kWindow, deviceScaleFactor: 0.5, scripts: kLight, ignoreHTTPSErrors: true };
    const opened = await openPage(kit.browser, address, options);
    t.after(opened.close);
    const { page } = opened;
    await page.evaluate(() => window.spineloft.ready);
    assert.deepEqual(await page.evaluate(() => [isSecureContext, typeof crypto.subtle, typeof SharedArrayBuffer]), [
      true,
      'object',
      'function',
    ]);
    await page.getByRole('button', { name: 'Open a class', exact: true }).click();
    await page.getByRole('button', { name: 'Open the class', exact: true }).click();
    await page.locator('.wall-words').waitFor();
    assert.equal(await page.locator('.wall-address').innerText(), new URL(address).host);
    assert.deepEqual(opened.troubles, []);
  },
);
