// A share server on a port of its own, and clients of its protocol: the page's own code.
import { createServer, request as ask } from 'node:http';
import { loadShell } from '../../browser/support/shell.mjs';
import { makeShare } from '../../../web/share/server.mjs';

/** The page's side of the protocol, for Node. */
export const loadClient = () =>
  loadShell(`
    export * from './room/server_side.ts';
    export { ClassRoom } from './room/class_room.ts';
    export { packMessage, unpackMessage } from './room/messages.ts';
  `);

/** Serves `store`; `url` ends with 'share/v1/'. `close` ends the server and the store. */
export async function startServer(store, { times = {}, ...options } = {}) {
  const said = [];
  const share = await makeShare({ store, log: (line) => said.push(line), ...options });
  const server = createServer({ ...share.times, ...times }, share.handle);
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address();
  return {
    url: `http://127.0.0.1:${port}/share/v1/`,
    root: `http://127.0.0.1:${port}/share/`,
    port,
    server,
    share,
    store,
    said,
    async close() {
      share.endStreams();
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
      await share.close();
    },
  };
}

/** A request with the path exactly as given: fetch would tidy `..` away. */
export function rawAsk(port, path, { method = 'GET', headers = {}, body } = {}) {
  return new Promise((resolve, reject) => {
    const sent = ask({ host: '127.0.0.1', port, path, method, headers }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () =>
        resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(chunks).toString() }),
      );
    });
    sent.on('error', reject);
    sent.end(body);
  });
}

/** Until `isTrue()` holds, or fails after a while. */
export async function until(isTrue, what, milliseconds = 20_000) {
  const end = performance.now() + milliseconds;
  while (!(await isTrue())) {
    if (performance.now() > end) throw new Error(`waited in vain for: ${what}`);
    await new Promise((done) => setTimeout(done, 10));
  }
}
