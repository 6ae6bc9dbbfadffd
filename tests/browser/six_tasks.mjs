// Counts what the six tasks of Help take by hand: node tests/browser/six_tasks.mjs [--pictures FOLDER]. Each is done
// from an empty profile, as a first visitor, with real pointer events and nothing but what the page shows, at three
// sizes. An action is a press, a tap, a stroke or a text that is typed; a scroll is one turn of the wheel or one drag of a
// panel until what is needed is in sight; a wrong turn is a refusal, a warning or an error that the page says.
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { openPage, startBrowser, startSite } from '../../.ci/lib/browser.mjs';
import { root } from '../../.ci/lib/paths.mjs';
import { findControl, onCanvas, strokeAlong } from './support/hands.mjs';
import { framed, idle, state } from './support/page.mjs';

const { values } = parseArgs({ options: { pictures: { type: 'string' }, only: { type: 'string' } } });
const kSizes = {
  '1440x900': { viewport: { width: 1440, height: 900 } },
  '1024x768': { viewport: { width: 1024, height: 768 }, hasTouch: true },
  '390x844': { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
};

/** A closed line through these shares of the picture, with points between. */
function closed(corners, between = 6) {
  return corners.flatMap(([ax, ay], i) => {
    const [bx, by] = corners[(i + 1) % corners.length];
    return Array.from({ length: between }, (_, k) => [ax + ((bx - ax) * k) / between, ay + ((by - ay) * k) / between]);
  });
}
const loop = (corners) => [...closed(corners), corners[0]];
const open = (corners) => closed(corners).slice(0, 6 * (corners.length - 1) + 1);
const round = (x, y, rx, ry, count = 24) =>
  Array.from({ length: count + 1 }, (_, i) => [
    x + rx * Math.cos((2 * Math.PI * i) / count),
    y + ry * Math.sin((2 * Math.PI * i) / count),
  ]);

const kZucchini = JSON.parse(readFileSync(join(root, 'assets/samples/samples.json'), 'utf8')).find(
  ({ id }) => id === 'zucchini',
);

class Visitor {
  actions = 0;
  scrolls = 0;
  wrong = 0;

  constructor(page, touch) {
    this.page = page;
    this.touch = touch;
    this.heard = new Set();
  }

  async tap(x, y) {
    // What is said may lie on it: that is closed first.
    const covers = await this.page.evaluateHandle(
      ([left, top]) => {
        const there = document.elementFromPoint(left, top);
        return there?.closest('button') ? null : (there?.closest('.toast')?.querySelector('.toast-close') ?? null);
      },
      [x, y],
    );
    if (covers.asElement()) {
      this.actions += 1;
      await covers.asElement().click();
    }
    this.actions += 1;
    if (this.touch) await this.page.touchscreen.tap(x, y);
    else await this.page.mouse.click(x, y);
    await this.listen();
  }

  /** A refusal, warning or error that was not there before is a wrong turn. */
  async listen() {
    await idle(this.page);
    await framed(this.page);
    const said = await this.page.locator('#toasts [role=alert] p').allInnerTexts();
    for (const text of said) {
      if (this.heard.has(text)) continue;
      this.heard.add(text);
      this.wrong += 1;
    }
  }

  /** Something of the DOM, such as a button of the bar. */
  async pressDom(selector) {
    const element = this.page.locator(selector).first();
    await element.scrollIntoViewIfNeeded();
    const box = await element.boundingBox();
    await this.tap(box.x + box.width / 2, box.y + box.height / 2);
  }

  /** A control of the canvas by its words; its tab is opened and its panel scrolled where that is needed. */
  async press(words, { tab, kind, row } = {}) {
    const which = { kind, row };
    let found = await findControl(this.page, words, which);
    if (!found && tab) {
      await this.press(tab, { kind: 'tab' });
      found = await findControl(this.page, words, which);
    }
    if (!found) {
      const { controls } = await state(this.page);
      throw new Error(`"${words}" is not among ${controls.map((one) => one.words).join(' | ')}`);
    }
    for (let turns = 0; !found.inSight && turns < 30; turns += 1) {
      this.scrolls += 1;
      await this.scrollTo(found);
      found = await findControl(this.page, words, which);
    }
    const [x, y, width, height] = found.at;
    const [at] = await onCanvas(this.page, [x + width / 2, y + height / 2]);
    await this.tap(at.x, at.y);
  }

  async scrollTo(found) {
    const canvas = await this.page.locator('#canvas').boundingBox();
    const middle = found.at[1] + found.at[3] / 2;
    const down = middle > canvas.height / 2;
    const x = Math.min(Math.max(found.at[0] + found.at[2] / 2, 20), canvas.width - 20);
    const [at] = await onCanvas(this.page, [x, canvas.height - 60]);
    if (this.touch) await strokeAlong(this.page, 'finger', [at, { x: at.x, y: at.y + (down ? -45 : 45) }]);
    else {
      await this.page.mouse.move(at.x, at.y);
      await this.page.mouse.wheel(0, down ? 120 : -120);
    }
    await framed(this.page);
  }

  /** A stroke through shares of the picture. */
  async draw(shares) {
    this.actions += 1;
    const path = await this.page.evaluate((points) => {
      const { width, height } = window.spineloft.state().picture;
      return points.map(([x, y]) => window.spineloft.imageToClient(x * width, y * height));
    }, shares);
    await strokeAlong(this.page, this.touch ? 'finger' : 'mouse', path);
    await this.listen();
  }

  async tapPicture(x, y) {
    const at = await this.page.evaluate(
      ([sx, sy]) => {
        const { width, height } = window.spineloft.state().picture;
        return window.spineloft.imageToClient(sx * width, sy * height);
      },
      [x, y],
    );
    await this.tap(at.x, at.y);
  }

  async turn() {
    this.actions += 1;
    const { solid } = await this.views();
    const path = Array.from({ length: 8 }, (_, i) => ({ x: solid.x - 40 + 10 * i, y: solid.y }));
    await strokeAlong(this.page, this.touch ? 'finger' : 'mouse', path);
  }

  /** The middle of the solid view, from the words above it. */
  async views() {
    const { controls } = await state(this.page);
    const name = controls.find(({ kind, words }) => kind === 'words' && words.startsWith('Solid'));
    const box = await this.page.locator('#canvas').boundingBox();
    const isBelow = name && name.at[0] < box.width / 3;
    const [solid] = await onCanvas(
      this.page,
      isBelow ? [box.width / 2, name.at[1] + 90] : [name.at[0] + 120, box.height / 2],
    );
    return { solid };
  }

  async save() {
    await this.pressDom('#bar-save');
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.pressDom('.menu [data-command=save-glb], .menu [role^=menuitem]'),
    ]);
    return download.suggestedFilename();
  }
}

const kParts = { tab: 'Parts' };
const kTasks = {
  sausage: async (me) => {
    await me.pressDom('#paper');
    await me.draw(round(0.5, 0.5, 0.32, 0.12));
    await me.draw(
      open([
        [0.2, 0.5],
        [0.8, 0.5],
      ]),
    );
    await me.turn();
  },
  vase: async (me) => {
    await me.pressDom('#paper');
    await me.draw(
      loop([
        [0.35, 0.15],
        [0.65, 0.15],
        [0.56, 0.45],
        [0.68, 0.85],
        [0.32, 0.85],
        [0.44, 0.45],
      ]),
    );
    await me.draw(
      open([
        [0.5, 0.17],
        [0.5, 0.83],
      ]),
    );
    await me.press('Scoop out', kParts);
    await me.press('Make it hollow');
    await me.turn();
  },
  mug: async (me) => {
    await me.pressDom('#paper');
    await me.draw(
      loop([
        [0.3, 0.2],
        [0.6, 0.2],
        [0.6, 0.8],
        [0.3, 0.8],
      ]),
    );
    await me.draw(
      open([
        [0.45, 0.22],
        [0.45, 0.78],
      ]),
    );
    await me.press('Scoop out', kParts);
    await me.press('Make it hollow');
    await me.press('New part', kParts);
    await me.draw(
      open([
        [0.58, 0.35],
        [0.76, 0.38],
        [0.76, 0.62],
        [0.58, 0.65],
      ]),
    );
    await me.press('Stick together', kParts);
  },
  zucchini: async (me) => {
    await me.pressDom('#samples .sample-open:has-text("zucchini")');
    await me.page.waitForFunction(() => window.spineloft.state().picture !== null);
    await me.draw(kZucchini.spine.map(([x, y]) => [x / kZucchini.width, y / kZucchini.height]));
    await me.turn();
  },
  bird: async (me) => {
    await me.pressDom('#paper');
    await me.draw(
      loop([
        [0.2, 0.45],
        [0.35, 0.3],
        [0.6, 0.35],
        [0.85, 0.3],
        [0.75, 0.55],
        [0.45, 0.65],
      ]),
    );
    await me.press('Puff');
    await me.tapPicture(0.5, 0.5);
    await me.press('Use this');
    await me.draw(
      loop([
        [0.45, 0.42],
        [0.68, 0.44],
        [0.6, 0.56],
        [0.46, 0.52],
      ]),
    );
    await me.pressDom('#bar-more');
    await me.pressDom('.menu [data-command=symmetry]');
    await me.pressDom('.menu [role=menuitemradio]:has-text("Front and back")');
    await me.press('Stick together', kParts);
  },
  robot: async (me) => {
    await me.pressDom('#paper');
    await me.press('Line');
    await me.draw(
      open([
        [0.5, 0.35],
        [0.5, 0.7],
      ]),
    );
    await me.press('Square', { tab: 'Slice' });
    for (const limb of [
      [
        [0.5, 0.15],
        [0.5, 0.4],
      ],
      [
        [0.25, 0.45],
        [0.75, 0.45],
      ],
      [
        [0.49, 0.6],
        [0.42, 0.9],
      ],
      [
        [0.51, 0.6],
        [0.58, 0.9],
      ],
    ]) {
      await me.press('New part', kParts);
      await me.draw(open(limb));
    }
    await me.press('Stick together', kParts);
    await me.pressDom('#bar-more');
    await me.pressDom('.menu [data-command=check-print]');
  },
};

const browser = await startBrowser();
const site = await startSite({ isolated: true });
const rows = [];
try {
  for (const [size, context] of Object.entries(kSizes)) {
    for (const [name, work] of Object.entries(kTasks)) {
      if (values.only && values.only !== name) continue;
      const opened = await openPage(browser, site.url, { deviceScaleFactor: values.pictures ? 1 : 0.5, ...context });
      const { page } = opened;
      await page.evaluate(() => window.spineloft.ready);
      const me = new Visitor(page, context.hasTouch === true);
      let end = 'done';
      try {
        await work(me);
        const file = await me.save();
        const { parts, steps } = await state(page);
        end = `${parts.length} parts, ${steps.map(({ kind, status }) => `${kind} ${status}`).join(', ') || 'no solid'}, ${file}`;
      } catch (thrown) {
        end = `NOT DONE: ${thrown.message.split('\n')[0].slice(0, 160)}`;
      }
      if (values.pictures) {
        mkdirSync(values.pictures, { recursive: true });
        await page.screenshot({ path: join(values.pictures, `task_${name}_${size}.png`) });
      }
      rows.push([size, name, me.actions, me.scrolls, me.wrong, end]);
      console.log(rows.at(-1).join(' | '), [...me.heard].join(' / '));
      await opened.close();
    }
  }
} finally {
  await browser.close();
  await site.close();
}
console.log('\n| size | task | actions | scrolls | wrong turns | end |\n|---|---|---|---|---|---|');
for (const row of rows) console.log(`| ${row.join(' | ')} |`);
