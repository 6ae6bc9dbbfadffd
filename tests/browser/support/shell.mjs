// Modules of the shell for Node: bundled, not type-checked.
import { build } from 'esbuild';
import { root } from '../../../.ci/lib/paths.mjs';

/** Loads what a piece of TypeScript in web/shell exports. */
export async function loadShell(contents) {
  const result = await build({
    absWorkingDir: root,
    stdin: { contents, resolveDir: `${root}/web/shell`, loader: 'ts' },
    bundle: true,
    write: false,
    format: 'esm',
    logLevel: 'silent',
    define: { 'navigator.platform': '"Linux"' },
  });
  return import(`data:text/javascript;base64,${Buffer.from(result.outputFiles[0].text).toString('base64')}`);
}
