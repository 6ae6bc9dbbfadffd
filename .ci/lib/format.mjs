// The format of the house: clang-format of the pinned version for C++, prettier for TypeScript, scripts and styles.
import { readdirSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { root } from './paths.mjs';
import { output, run } from './run.mjs';

const kFormatter = 'clang-format-19';

function filesOf(folder, pattern) {
  return readdirSync(join(root, folder)).flatMap((name) => {
    const path = join(folder, name);
    if (statSync(join(root, path)).isDirectory()) return filesOf(path, pattern);
    return pattern.test(name) ? [path] : [];
  });
}

async function cppErrors() {
  if (output(kFormatter, ['--version']) === null) return [`${kFormatter} is missing (a Debian package of that name)`];
  const files = ['engine', 'web', 'tests'].flatMap((folder) => filesOf(folder, /\.(h|cpp)$/));
  const options = { cwd: root, allowFailure: true, log: 'format' };
  const { text } = await run('clang-format', kFormatter, ['--dry-run', '--ferror-limit=1', ...files], options);
  const wrong = [...text.matchAll(/^(\S+?):(\d+):\d+: \w+: code should be clang-formatted/gm)];
  return [...new Set(wrong.map(([, path]) => path))].map((path) => `${path}: not as ${kFormatter} writes it`);
}

async function scriptErrors() {
  const prettier = join(root, 'node_modules/prettier/bin/prettier.cjs');
  const places = ['.ci', 'web/shell', 'tests'].map((folder) => `${folder}/**/*.{ts,mjs,css}`);
  const options = { cwd: root, allowFailure: true, log: 'format' };
  const args = [prettier, '--list-different', ...places];
  const { text, status } = await run('prettier', process.execPath, args, options);
  if (status === 0) return [];
  const lines = text.trim().split('\n');
  return lines.map((line) => `${relative(root, join(root, line))}: not as prettier writes it`);
}

/** Every file that is not formatted, as a sentence. */
export async function formatErrors() {
  return [...(await cppErrors()), ...(await scriptErrors())];
}
