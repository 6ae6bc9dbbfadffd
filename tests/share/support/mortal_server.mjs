// A share server that a test kills: `node mortal_server.mjs STORE [WRITE]`. It prints its port; with WRITE, on a
// file, it ends itself by SIGKILL before the statement of that number that writes, or before what it wrote is acknowledged.
import { openStore } from '../../../web/share/store.mjs';
import { startServer } from './server.mjs';

const [, , file, last] = process.argv;
let writes = 0;
const onWrite = () => {
  writes += 1;
  if (writes === Number(last)) process.kill(process.pid, 'SIGKILL');
};
const requests = { max: 1_000_000, timeWindow: 60_000 };
const server = await startServer(await openStore(file, last ? { onWrite } : {}), {
  limits: { requests, models: requests, sweepMs: 200 },
});
process.stdout.write(`${server.port}\n`);
process.on('SIGTERM', () => void server.close());
