// npm run serve:share: the share server without the site, for a host that serves dist/ by other means.
import { mainProgram, say, Stop } from './lib/run.mjs';
import { setup } from './setup.mjs';

await mainProgram(async () => {
  const stopped = new Promise((resolve) => process.on('spineloft-stop', resolve));
  await setup(['store']);
  const { serveMain, UsageError } = await import('../web/share/serve.mjs');
  await serveMain(process.argv.slice(2), { say, stopped }).catch((error) => {
    throw error instanceof UsageError ? new Stop(error.message) : error;
  });
});
