// What every browser test needs: the built site on a free port, a headless Chromium, and a page that keeps count of
// console errors, exceptions and requests to elsewhere.
import { existsSync } from 'node:fs';
import { distDir } from './paths.mjs';
import { Stop } from './run.mjs';
import { serveFolder } from './server.mjs';

/**
 * What a Chromium of the tests is started with. As on a machine without a graphics card, the page is put together by the
 * processor, and only WebGL goes through SwiftShader: to draw the page with it as well takes seconds for each new page.
 */
export const browserFlags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-gpu-compositing',
  '--font-render-hinting=none', // letters stand as in a browser with windows
];

/** Serves dist/ on a free port; options as serveFolder's (`isolated: false` for the single-thread build). */
export function startSite(options = {}) {
  if (!existsSync(distDir)) throw new Stop('There is no dist/ yet: run npm run build first.');
  return serveFolder(distDir, options);
}

/**
 * Debian's Chromium, or the one $SPINELOFT_CHROMIUM names. The headless shell has no windows of its own, whose menus are pages,
 * too: opening one of ours takes half the time.
 */
export function browserPath() {
  const path = process.env.SPINELOFT_CHROMIUM ?? '/usr/bin/chromium-headless-shell';
  if (!existsSync(path)) throw new Stop(`There is no ${path}; the package chromium-headless-shell provides it.`);
  return path;
}

export async function startBrowser() {
  const { chromium } = await import('playwright-core');
  return chromium.launch({ executablePath: browserPath(), args: browserFlags, headless: true });
}

/**
 * Opens `url` in a fresh context (`contextOptions` as Playwright's: viewport, hasTouch, deviceScaleFactor ...). `scripts` are
 * functions that run in its pages before theirs.
 * From about:blank the origin is that of the first request.
 * `troubles` collects console errors, uncaught exceptions, failed requests and requests that leave the origin.
 */
export async function openPage(browser, url, { scripts = [], ...contextOptions } = {}) {
  // A service worker would answer what tests hold back or alter.
  const usual = { viewport: { width: 1440, height: 900 }, serviceWorkers: 'block' };
  const context = await browser.newContext({ ...usual, ...contextOptions });
  for (const script of scripts) await context.addInitScript(script);
  const page = await context.newPage();
  const troubles = [];
  let origin = url === 'about:blank' ? null : new URL(url).origin;
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(`console: ${message.text()} ${message.location().url}`);
  });
  page.on('pageerror', (error) => troubles.push(`exception: ${error.message}`));
  page.on('requestfailed', (request) => {
    // A page that is left calls off what it still waits for, such as the script of its threads.
    if (request.failure()?.errorText !== 'net::ERR_ABORTED') troubles.push(`request failed: ${request.url()}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) troubles.push(`status ${response.status()}: ${response.url()}`);
  });
  page.on('request', (request) => {
    const at = new URL(request.url());
    if (!/^(http|ws)s?:$/.test(at.protocol)) return;
    origin ??= at.origin;
    if (at.origin !== origin) troubles.push(`left the origin: ${request.url()}`);
  });
  await page.goto(url, { waitUntil: 'load' });
  return { page, context, troubles, close: () => context.close() };
}
