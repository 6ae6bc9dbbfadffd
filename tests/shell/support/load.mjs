// Modules of the shell that need no browser.
import { build } from 'esbuild';
import { root } from '../../../.ci/lib/paths.mjs';

/** The module web/shell/`file`, with what it imports. */
export async function load(file) {
  const result = await build({
    absWorkingDir: root,
    entryPoints: [`web/shell/${file}`],
    bundle: true,
    write: false,
    format: 'esm',
    logLevel: 'silent',
  });
  return import(`data:text/javascript;base64,${Buffer.from(result.outputFiles[0].text).toString('base64')}`);
}
