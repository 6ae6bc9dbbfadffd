// People who use the keyboard, a screen reader, large type or reduced motion.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { root } from '../../.ci/lib/paths.mjs';
import { drawWithMouse, strokeAlong } from './support/hands.mjs';
import {
  done,
  downloaded,
  exported,
  idle,
  kPhone,
  onPage,
  openPicture,
  openWithPart,
  pixels,
  run,
  state,
  toastText,
  toClient,
  useSite,
} from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const axe = readFileSync(join(root, 'node_modules/axe-core/axe.min.js'), 'utf8');

async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    // Colours on their way to another look are no one's colours.
    const changes = document.getAnimations().filter((one) => one instanceof CSSTransition);
    await Promise.all(changes.map(({ finished }) => finished.catch(() => undefined)));
    const { violations: found } = await window.axe.run(document, { resultTypes: ['violations'] });
    return found
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(' ')).join(', ')}`);
  });
}

const focused = (page) =>
  page.evaluate(() => {
    const element = document.activeElement;
    return element.dataset.command ?? element.id ?? element.className;
  });

/** What the system asks for, as the page is told of it. */
const kLooks = {
  plain: {},
  dark: { colorScheme: 'dark' },
  'more contrast, dark': { colorScheme: 'dark', contrast: 'more' },
  'forced colours': { forcedColors: 'active' },
};

for (const [name, context, looks] of [
  ['desktop', {}, Object.keys(kLooks)],
  ['phone', kPhone, ['plain']],
]) {
  test(`axe finds nothing serious on the start page, at work, in menus and dialogs, in every look (${name})`, () =>
    onPage(kit, { ...context, alone: true }, async (page) => {
      const check = async (where) => {
        for (const look of looks) {
          await page.emulateMedia({
            colorScheme: 'light',
            contrast: 'no-preference',
            forcedColors: 'none',
            ...kLooks[look],
          });
          assert.deepEqual(await violations(page), [], `${where}, ${look}`);
        }
      };
      await check('start page');
      await openWithPart(page, tube.png, tube.middle);
      await check('at work');
      await page.locator('#bar-more').click();
      await check('More menu');
      await page.keyboard.press('Escape');
      await page.locator('#bar-save').click();
      await check('Save menu');
      await page.keyboard.press('Escape');
      await page.keyboard.press('?');
      await page.locator('dialog.sheet').waitFor();
      await check('shortcut sheet');
    }));
}

test('the page is dark where the system asks for it, the canvas as well, and changes with it; saved pictures do not', () =>
  onPage(kit, { alone: true, draws: true, colorScheme: 'dark' }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const brightness = async (clip) => {
      const { data } = await pixels(page, clip);
      return data.reduce((sum, value) => sum + value, 0) / data.length;
    };
    const panel = await page.evaluate(() => {
      const { x, y, width, height } = document.getElementById('canvas').getBoundingClientRect();
      return { x: x + width - 12, y: y + height - 40, width: 8, height: 8 };
    });
    const solidView = { x: 700, y: 80, width: 60, height: 30 };
    const bar = { x: 400, y: 2, width: 8, height: 6 };
    const saved = Buffer.from(await exported(page, 'glb'));
    const dark = [await brightness(panel), await brightness(solidView), await brightness(bar)];
    await page.emulateMedia({ colorScheme: 'light' });
    // The page hears of it before its next frame, which a busy machine draws late.
    for (let i = 0; i < 20 && (await brightness(panel)) <= dark[0] + 60; ++i) {
      await page.evaluate(() => new Promise(requestAnimationFrame));
      await idle(page);
    }
    const light = [await brightness(panel), await brightness(solidView), await brightness(bar)];
    for (let i = 0; i < dark.length; ++i) assert.ok(dark[i] + 60 < light[i], `${i}: ${dark[i]} against ${light[i]}`);
    assert.ok(saved.equals(Buffer.from(await exported(page, 'glb'))));
  }));

test('the canvas has the colours that the system forces, and more contrast where it is asked for, as soon as it changes', () =>
  onPage(kit, { alone: true, draws: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const { x, y, width, height } = await page.locator('#canvas').boundingBox();
    const panel = { x: x + width - 238, y: y + 60, width: 236, height: 200 };
    const solidView = { x: x + width - 300, y: y + height / 2, width: 8, height: 8 };
    const seen = async (media) => {
      await page.emulateMedia({ colorScheme: 'light', contrast: 'no-preference', forcedColors: 'none', ...media });
      await page.evaluate(() => new Promise(requestAnimationFrame)); // the page hears of it before its next frame
      await idle(page);
      const system = await page.evaluate(() => {
        const probe = document.createElement('span');
        probe.style.setProperty('forced-color-adjust', 'none');
        document.body.append(probe);
        const colours = ['Canvas', 'CanvasText', 'Highlight'].map((name) => {
          probe.style.color = name;
          return getComputedStyle(probe).color.match(/\d+/g).slice(0, 3).map(Number);
        });
        probe.remove();
        return colours;
      });
      const coloursIn = async (clip) => {
        const { data } = await pixels(page, clip);
        const found = new Set();
        for (let i = 0; i < data.length; i += 4) found.add([data[i], data[i + 1], data[i + 2]].join());
        return found;
      };
      return { system: system.map(String), panel: await coloursIn(panel), ground: await coloursIn(solidView) };
    };
    const plain = await seen({});
    for (const colorScheme of ['light', 'dark']) {
      const { system, panel, ground } = await seen({ forcedColors: 'active', colorScheme });
      for (const colour of system) assert.ok(panel.has(colour), `${colorScheme}: ${colour} on the panel`);
      assert.deepEqual([...ground], [system[0]], 'the ground of the solid view');
    }
    const sharp = await seen({ contrast: 'more' });
    assert.ok(sharp.panel.has('107,102,88') && !plain.panel.has('107,102,88'), 'the lines round tiles');
    assert.deepEqual([...(await seen({})).panel].sort(), [...plain.panel].sort(), 'and back again');
  }));

test('by keyboard alone: open a sample, make a part, change it, save it', () =>
  onPage(kit, { alone: true }, async (page) => {
    for (const command of ['language', 'open-picture']) {
      await page.keyboard.press('Tab');
      assert.equal(await focused(page), command);
    }
    const onSample = () => page.evaluate(() => document.activeElement.closest('#samples') !== null);
    for (let i = 0; i < 4 && !(await onSample()); ++i) await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    await idle(page);
    assert.equal(await focused(page), 'canvas', 'the drawing has the focus');
    const { picture } = await state(page);
    await page.keyboard.press('Enter'); // the pen appears in the middle of the picture
    for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('Space'); // and goes down
    for (let i = 0; i < 8; ++i) await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('Space');
    await idle(page);
    assert.equal((await state(page)).parts.length, 1, `a part on a picture of ${picture.width} by ${picture.height}`);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Shift+Tab');
    assert.equal(
      await page.evaluate(() => document.activeElement.closest('[role=toolbar]') !== null),
      true,
      'back to the bar',
    );
    await page.keyboard.press('Home');
    assert.equal(await focused(page), 'open-picture');
    for (let i = 0; i < 12 && (await focused(page)) !== 'set-section'; ++i) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await page.keyboard.press('s');
    await page.keyboard.press('Enter');
    await idle(page);
    assert.equal((await state(page)).parts[0].section, 'square');
    assert.equal(await focused(page), 'set-section', 'focus returns to the button');
    await page.keyboard.press('End');
    assert.equal(await focused(page), 'bar-save');
    const { name } = await downloaded(page, async () => {
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('Enter');
    });
    assert.match(name, /\.(spineloft|glb)$/);
  }));

test('Tab goes through the page and is never held by the canvas', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await page.locator('#canvas').focus();
    await page.keyboard.press('Tab');
    assert.notEqual(await focused(page), 'canvas');
    await page.locator('#canvas').focus();
    await page.keyboard.press('Shift+Tab');
    assert.equal(await page.evaluate(() => document.activeElement.closest('[role=toolbar]') !== null), true);
  }));

test('the command bar mirrors the command table', () =>
  onPage(kit, { alone: true }, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const commands = await page.evaluate(() => window.spineloft.commands());
    assert.equal(new Set(commands.map(({ id }) => id)).size, commands.length);
    for (const id of ['undo', 'redo', 'delete-part']) {
      assert.equal(
        await page.locator(`#bar-items [data-command=${id}]`).getAttribute('aria-disabled'),
        commands.find((c) => c.id === id).enabled ? null : 'true',
        id,
      );
    }
    assert.equal(await page.locator('#bar-items [data-command=draw]').getAttribute('aria-pressed'), 'true');
    await done(page, 'draw-spine', { stroke: tube.middle });
    await page.waitForFunction(
      () => !document.querySelector('#bar-items [data-command=undo]').hasAttribute('aria-disabled'),
    );
    assert.equal(await page.locator('#bar-save').getAttribute('aria-disabled'), null);
    const shown = await page
      .locator('#bar-items button:visible')
      .evaluateAll((list) => list.map((button) => button.dataset.command));
    await page.locator('#bar-more').click();
    const now = await page.evaluate(() => window.spineloft.commands());
    const offered = now.filter(({ id, menu, enabled }) => menu && enabled && !shown.includes(id));
    assert.deepEqual(
      (
        await page.locator('.menu [data-command]').evaluateAll((list) => list.map(({ dataset }) => dataset.command))
      ).sort(),
      offered.map(({ id }) => id).sort(),
    );
  }));

/** Controls of commands, in the bar and in the open menu, that do not say what the table says; [] is right. */
const differing = (page) =>
  page.evaluate(() => {
    const commands = new Map(window.spineloft.commands().map((command) => [command.id, command]));
    const controls = document.querySelectorAll('#bar [data-command], .menu [data-command]:not([data-value])');
    return [...controls]
      .filter((element) => {
        const command = commands.get(element.dataset.command);
        const isOn = element.getAttribute('aria-checked') ?? element.getAttribute('aria-pressed');
        const saysOn = typeof command?.toggled === 'boolean' && isOn !== null ? isOn : String(command?.toggled);
        const isOff = element.getAttribute('aria-disabled') === 'true';
        return !command || isOff === command.enabled || saysOn !== String(command.toggled);
      })
      .map((element) => element.dataset.command);
  });

test('menus say what the command table says, whatever was done, also while they are open', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await done(page, 'draw-spine', { stroke: tube.middle.map(([x, y]) => [x, y + 6]) });
    const steps = [
      ['select-part', { id: 1 }],
      ['snap-to-surface'],
      ['select-all'],
      ['scoop-out', { part: 1 }],
      ['point-opening'],
      ['cancel'],
      ['undo'],
    ];
    const item = (id) => page.locator(`.menu [data-command=${id}]`);
    for (const [id, args] of steps) {
      await run(page, id, args);
      await page.locator('#bar-more').click();
      assert.deepEqual(await differing(page), [], id);
      await page.keyboard.press('Escape');
    }
    await run(page, 'select-part', { id: 1 });
    await page.locator('#bar-more').click();
    for (const [id, isOff] of [
      ['delete-part', 'true'],
      ['undo', null],
    ]) {
      await run(page, id);
      if (id === 'undo') await run(page, 'select-part', { id: 1 });
      assert.equal(await item('duplicate').getAttribute('aria-disabled'), isOff);
      assert.deepEqual(await differing(page), []);
    }
    await page.keyboard.press('Escape');
  }));

/** Buttons that run no command of the table: they open a menu or a dialog, close one, or open what is no command. */
const kNoCommand = [
  '#bar-more',
  '#mirror button', // those of panels that run no command
  '#bar-save',
  '#camera',
  '#class-start button',
  '#class-strip button',
  '#wall button',
  '#progress-cancel',
  '#coach-close',
  '.sample-open',
  '.model-more',
  '.dialog-close',
  '.toast-close',
  'dialog [value=cancel]',
].join();

test('every button and menu item that runs a command carries its id, and no other', () =>
  onPage(kit, { alone: true }, async (page) => {
    const check = async (where) => {
      const found = await page.evaluate((others) => {
        const ids = new Set(window.spineloft.commands().map(({ id }) => id));
        const buttons = [...document.querySelectorAll('button, [role^=menuitem]')];
        return {
          count: document.querySelectorAll('[data-command]').length,
          unknown: [...document.querySelectorAll('[data-command]')]
            .map(({ dataset }) => dataset.command)
            .filter((id) => !ids.has(id)),
          without: buttons
            .filter((element) => !element.dataset.command && !element.matches(others))
            .map((element) => element.outerHTML.slice(0, 120)),
        };
      }, kNoCommand);
      assert.ok(found.count > 0, where);
      assert.deepEqual(found.unknown, [], where);
      assert.deepEqual(found.without, [], where);
    };
    await check('start page');
    await openWithPart(page, tube.png, tube.middle);
    await check('at work');
    for (const button of ['#bar-more', '#bar-save', '#bar-items [data-command=set-section]']) {
      await page.locator(button).click();
      await check(button);
      await page.keyboard.press('Escape');
    }
    await run(page, 'rename-model');
    await page.locator('dialog').waitFor();
    await check('a question');
    assert.equal(await page.locator('dialog [type=submit]').getAttribute('data-command'), 'rename-model');
    await page.keyboard.press('Escape');
    await run(page, 'open-model');
    await page.locator('dialog.models-dialog .model').first().waitFor();
    await check('your models');
    await page.locator('dialog .model-more').first().click();
    await check('more about a model');
    assert.deepEqual(
      await page.locator('.menu [data-command]').evaluateAll((list) => list.map(({ dataset }) => dataset.command)),
      ['open-model', 'duplicate-model', 'rename-model', 'delete-model'],
    );
  }));

test('every icon the table names is drawn', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const names = await page.evaluate(() => [...new Set(window.spineloft.commands().map(({ icon }) => icon))]);
    const known = readFileSync(join(root, 'web/shell/icons.ts'), 'utf8');
    for (const name of names) assert.match(known, new RegExp(`\\b'?${name}'?:`), `icon ${name}`);
  }));

test('the shortcut sheet lists the keys of the table and closes with Escape', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    await page.keyboard.press('?');
    const sheet = page.getByRole('dialog', { name: 'Help' });
    const text = await sheet.innerText();
    const kKeys = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' };
    for (const { label, shortcut } of await page.evaluate(() => window.spineloft.commands())) {
      if (!shortcut) continue;
      const keys = shortcut.split(/,\s*/)[0].replace(/Arrow\w+/, (key) => kKeys[key]);
      assert.ok(text.includes(label) && text.includes(keys), `${label}: ${keys}`);
    }
    await page.keyboard.press('Escape');
    assert.equal(await sheet.count(), 0);
  }));

test('renaming asks in a dialog with a text field, and keys typed there draw nothing', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await run(page, 'rename-part');
    const field = page.getByRole('textbox');
    await field.waitFor();
    await field.fill('n1 Tail of h');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.spineloft.state().parts[0].name === 'n1 Tail of h');
    assert.equal((await state(page)).parts.length, 1);
  }));

test('what happens is said in live regions: the picture, the parts, refusals', () =>
  onPage(kit, {}, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const line = page.locator('#status');
    assert.equal(await line.getAttribute('aria-live'), 'polite');
    assert.equal(await line.innerText(), 'tube.png is open.');
    assert.equal(await page.locator('#status-end').innerText(), 'No part yet');
    await done(page, 'draw-spine', { stroke: tube.middle });
    await page.waitForFunction(() => /^1 part · ./.test(document.getElementById('status-end').textContent));
    await run(page, 'delete-part');
    const [at] = await toClient(page, [[100, 100]]);
    const twiceRound = Array.from({ length: 14 }, (_, i) => ({
      x: at.x + 50 * Math.sin(i),
      y: at.y + 50 * (1 - Math.cos(i)),
    }));
    await strokeAlong(page, 'mouse', [
      ...twiceRound,
      { x: at.x + 160, y: at.y + 100 },
      { x: at.x + 330, y: at.y + 110 },
    ]);
    assert.match(await toastText(page), /crosses itself/);
  }));

test('what a command says of its step in a toast is not said in the status line as well', () =>
  onPage(kit, {}, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    await page.evaluate(() => {
      window.said = [];
      const watch = (id) =>
        new MutationObserver(() => window.said.push(document.getElementById(id).innerText.trim())).observe(
          document.getElementById(id),
          { childList: true, characterData: true, subtree: true },
        );
      watch('status');
      watch('toasts');
    });
    await run(page, 'remove-picture', { picture: 1 });
    const said = (await page.evaluate(() => window.said)).filter((text) => text !== '');
    assert.equal(said.length, 1, said.join(' | '));
    assert.match(said[0], /^Removed .* and its part/);
    await run(page, 'undo');
    assert.match(await page.locator('#status').innerText(), /^Undone: /);
  }));

test('reduced motion: the ghost hand stands still and shows the whole line', () =>
  onPage(kit, { alone: true, reducedMotion: 'reduce' }, async (page) => {
    await page.locator('.sample .ghost-line').waitFor({ state: 'attached' });
    assert.equal(
      await page.evaluate(
        () => document.getAnimations().filter((animation) => animation.playState === 'running').length,
      ),
      0,
    );
    assert.equal(await page.locator('.sample .ghost-line').evaluate((line) => line.style.strokeDasharray), '');
  }));

test('the ghost hand draws three times and rests; it leaves with the first part', () =>
  onPage(kit, { alone: true }, async (page) => {
    await page.locator('.sample .ghost-line').waitFor({ state: 'attached' });
    assert.ok((await page.evaluate(() => document.getAnimations().length)) > 0);
    await page.locator('.sample-open').first().click();
    await page.waitForFunction(() => window.spineloft.state().picture !== null);
    await page.locator('#ghost-layer .ghost').waitFor({ state: 'attached' });
    assert.equal(await page.locator('#hint').isVisible(), true);
    const { spine } = JSON.parse(readFileSync(join(root, 'assets/samples/samples.json'), 'utf8'))[0];
    await drawWithMouse(page, spine);
    await page.waitForFunction(() => document.querySelector('#ghost-layer .ghost') === null);
    assert.equal(await page.locator('#hint').isVisible(), false);
  }));

test('with forced colours dialogs have an edge, and what cannot be pressed has the colour for that', () =>
  onPage(kit, { alone: true, forcedColors: 'active' }, async (page) => {
    await openPicture(page, tube.png, 'tube.png');
    const colours = await page.evaluate(() => {
      const grey = document.createElement('span');
      grey.style.color = 'GrayText';
      document.body.append(grey);
      const colour = (element) => getComputedStyle(element).color;
      const button = document.querySelector('#bar-items [data-command=redo]');
      return [button.getAttribute('aria-disabled'), colour(button) === colour(grey)];
    });
    assert.deepEqual(colours, ['true', true]);
    await page.keyboard.press('/');
    assert.equal(await page.locator('dialog').evaluate((dialog) => getComputedStyle(dialog).borderTopStyle), 'solid');
  }));

test('at 200 % zoom nothing is cut off and everything can be reached', () =>
  onPage(kit, { alone: true, viewport: { width: 640, height: 400 }, deviceScaleFactor: 2 }, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    const last = page.locator('.sample-open').last();
    await last.scrollIntoViewIfNeeded();
    assert.equal(await last.isVisible(), true);
    await openPicture(page, tube.png, 'tube.png');
    for (const id of ['bar-more', 'bar-save']) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= 640, id);
    }
    await page.locator('#bar-more').click();
    const menu = await page.getByRole('menu').boundingBox();
    assert.ok(menu.y + menu.height <= 400, 'the menu scrolls inside the window');
  }));

/** In the page, before its own scripts: the browser's text is twice as large; nothing is zoomed. */
const withLargeText = () =>
  new MutationObserver((_, seen) => {
    if (!document.head) return; // an element before that is not the page's own
    document.documentElement.style.fontSize = '200%';
    seen.disconnect();
  }).observe(document, { childList: true, subtree: true });

test('with text of twice the size and no zoom the page is laid out as at 200 %: words on the canvas are as large, hands meet what they see, and dialogs stay within the window', () =>
  onPage(kit, { alone: true, viewport: { width: 1280, height: 800 }, scripts: [withLargeText] }, async (page) => {
    const within = async (selector) => {
      const { x, y, width, height } = await page.locator(selector).boundingBox();
      assert.ok(
        x >= 0 && y >= 0 && x + width <= 1280.5 && y + height <= 800.5,
        `${selector}: ${[x, y, width, height]}`,
      );
    };
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    assert.equal(await page.locator('.lead').evaluate((lead) => getComputedStyle(lead).fontSize), '34px');
    for (const id of ['#choose', '#paper']) await within(id);
    await openPicture(page, tube.png, 'tube.png');
    for (const id of ['#bar-more', '#bar-help', '#bar-save', '#home']) await within(id);
    // A line along the middle is found where the hand drew it.
    await drawWithMouse(page, tube.middle);
    const [part] = (await state(page)).parts;
    const [first, last] = [part.bone[0], part.bone.at(-1)];
    assert.ok(Math.hypot(first[0] - tube.middle[0][0], first[1] - tube.middle[0][1]) < 30, `${first}`);
    assert.ok(Math.hypot(last[0] - tube.middle.at(-1)[0], last[1] - tube.middle.at(-1)[1]) < 30, `${last}`);
    // What is pressed is where the mirror says that it is.
    const home = page.locator('#mirror [data-command=move]');
    await home.waitFor({ state: 'attached' });
    const box = await home.boundingBox();
    assert.ok(box.width >= 60, `${box.width} pixels: as large as the text`);
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await idle(page);
    assert.equal((await state(page)).tool, 'move');
    await page.locator('#bar-more').click();
    await within('.menu');
    await page.keyboard.press('Escape');
    for (const command of ['help', 'share-model', 'find-command']) {
      await run(page, command);
      await page.locator('dialog').waitFor();
      await within('dialog');
      await page.keyboard.press('Escape');
      await page.locator('dialog').waitFor({ state: 'detached' });
    }
  }));
