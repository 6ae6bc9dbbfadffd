// Running programs, telling the user about it, and failing with a sentence and the log's tail.
import { spawn, spawnSync } from 'node:child_process';
import { closeSync, mkdirSync, openSync, readFileSync, writeSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { buildDir } from './paths.mjs';

/** An expected failure: its message is all the user needs to see. */
export class Stop extends Error {}

const children = new Set();
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
  process.on(signal, () => {
    for (const child of children) stopGroup(child);
    if (!process.listenerCount('spineloft-stop')) {
      process.stderr.write('\nInterrupted. The same command goes on from here.\n');
      process.exit(signal === 'SIGINT' ? 130 : 143);
    }
    process.emit('spineloft-stop', signal);
  });
}

function stopGroup(child) {
  try {
    process.kill(-child.pid, 'SIGTERM');
  } catch {
    // It has ended on its own already.
  }
}

let sayTo = process.stdout;

export function say(line = '') {
  sayTo.write(line + '\n');
}

/** From now on progress goes to standard error: standard output belongs to the program that is run. */
export function talkOnStderr() {
  sayTo = process.stderr;
}

export function duration(milliseconds) {
  const seconds = milliseconds / 1000;
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}

/** Standard output of a quick program, trimmed; null if it is missing or fails. */
export function output(command, args = [], options = {}) {
  const done = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 28, ...options });
  return done.status === 0 ? done.stdout.trim() : null;
}

export function logFile(name) {
  return join(buildDir, 'logs', `${name}.log`);
}

function tail(file, lines) {
  return readFileSync(file, 'utf8').trimEnd().split('\n').slice(-lines).join('\n');
}

/** Says every half a minute how far a long command is, from the `[12/300]` or `[ 40%]` it prints. */
function progressTeller(label) {
  const started = Date.now();
  let where = '';
  const timer = setInterval(() => {
    say(`  ... ${label}: ${where ? where + ', ' : ''}${duration(Date.now() - started)} so far`);
  }, 30000);
  return {
    see(text) {
      const hits = text.match(/\[\s*\d+(?:%|\/\d+)\]/g);
      if (hits) where = hits[hits.length - 1].replace(/[[\]\s]/g, '');
    },
    end: () => clearInterval(timer),
  };
}

/**
 * Runs a command to its end; its output goes to the log `options.log` (and to the screen with `options.show`).
 * Resolves to what it printed on both streams; a failure throws Stop with the log's tail.
 */
export function run(label, command, args, options = {}) {
  const { cwd, env, log = 'setup', show = false, allowFailure = false, timeout = 0 } = options;
  const file = logFile(log);
  mkdirSync(dirname(file), { recursive: true });
  const out = openSync(file, 'a');
  writeSync(out, `\n=== ${new Date().toISOString()} ${label}\n$ ${[command, ...args].join(' ')}\n`);
  const teller = progressTeller(label);
  const chunks = [];
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      cwd,
      env: { ...process.env, ...env },
      stdio: ['ignore', 'pipe', 'pipe'],
      detached: true,
    });
    children.add(child);
    let timedOut = false;
    const clock = timeout
      ? setTimeout(() => {
          timedOut = true;
          stopGroup(child);
        }, timeout)
      : null;
    const take = (chunk) => {
      chunks.push(chunk);
      writeSync(out, chunk);
      teller.see(chunk.toString());
      if (show) process.stdout.write(chunk);
    };
    child.stdout.on('data', take);
    child.stderr.on('data', take);
    const finish = (problem, status) => {
      if (clock) clearTimeout(clock);
      teller.end();
      children.delete(child);
      closeSync(out);
      const text = Buffer.concat(chunks).toString();
      if (!problem || allowFailure) return resolve({ text, status, problem });
      const shown = show ? '' : `\n${tail(file, 40)}`;
      reject(new Stop(`${label}: ${problem}. The whole log is in ${file}.${shown}`));
    };
    child.on('error', (error) => finish(`${command} could not be started (${error.code})`, null));
    child.on('close', (status, signal) => {
      if (timedOut) return finish(`stopped after ${duration(timeout)}`, status);
      if (signal) return finish(`ended by ${signal}`, status);
      finish(status === 0 ? '' : `failed with exit code ${status}`, status);
    });
  });
}

/** Runs `main`, turns a Stop into one message and exit code 1, and shows the stack of a bug. */
export async function mainProgram(main) {
  try {
    const code = await main();
    process.exitCode = code ?? 0;
  } catch (error) {
    process.stderr.write(`\n${error instanceof Stop ? error.message : error.stack}\n`);
    process.exitCode = 1;
  }
}
