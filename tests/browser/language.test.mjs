// The page in other languages: chosen by the visitor or by the browser, kept, whole, and with room for longer words.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { root } from '../../.ci/lib/paths.mjs';
import { sample } from '../support/rounds.mjs';
import { done, framed, idle, kPhone, kTablet, onPage, openWithPart, reload, run, useSite } from './support/page.mjs';
import { tubePicture } from './support/pictures.mjs';

const kit = useSite();
const tube = tubePicture();
const words = (id) => JSON.parse(readFileSync(join(root, `assets/words/${id}.json`), 'utf8'));
const [german, arabic] = ['de', 'ar'].map(words);

const kSizes = { desktop: { viewport: { width: 1440, height: 900 } }, tablet: kTablet, phone: kPhone };

/** Waits until page and canvas speak this language. */
const spoken = (page, id) => page.locator(`body[data-language=${id}]`).waitFor();

const heard = (page) =>
  page.evaluate(() => {
    const html = document.documentElement;
    return { lang: html.lang, dir: getComputedStyle(html).direction };
  });

async function speak(page, id) {
  await run(page, 'language', { language: id });
  await spoken(page, id);
  await framed(page);
}

/** A stand-in for the German catalogue: `change` makes each message of its English. */
async function replaceGerman(page, change) {
  const messages = Object.fromEntries(Object.keys(german).map((text) => [text, change(text)]));
  await page.route('**/assets/words/de-*.json', (route) => route.fulfill({ json: messages }));
}

/** Each state of the page that has words of its own, by what leads there from the one before. */
const kStates = [
  ['the start page', async () => undefined],
  ['a part', (page) => openWithPart(page, tube.png, tube.middle)],
  ['More', (page) => page.locator('#bar-more').click()],
  [
    'the search',
    async (page) => {
      await page.keyboard.press('Escape');
      await page.keyboard.press('/');
      await page.keyboard.type('twist'); // finds choices of a command
      await page.getByRole('option').first().waitFor();
    },
  ],
  [
    'Help',
    async (page) => {
      await page.keyboard.press('Escape');
      await page.locator('#bar-help').click();
      for (const summary of await page.locator('dialog summary').all()) await summary.click();
    },
  ],
  [
    'your models',
    async (page) => {
      await page.keyboard.press('Escape');
      await run(page, 'open-model');
    },
  ],
  [
    'the start page again',
    async (page) => {
      await page.keyboard.press('Escape');
      await done(page, 'new-model');
    },
  ],
];

test('the visitor chooses a language on the start page, it is kept, and can be changed back in Help', () =>
  onPage(kit, { alone: true }, async (page) => {
    assert.deepEqual(await heard(page), { lang: 'en', dir: 'ltr' });
    await page.locator('#language').click();
    await page.locator('[role=menuitemradio][data-command=language][data-value=de]').click();
    await spoken(page, 'de');
    assert.deepEqual(await heard(page), { lang: 'de', dir: 'ltr' });
    assert.equal(await page.locator('#choose').innerText(), german['Choose a picture']);
    assert.equal(await page.locator('#language').innerText(), 'Deutsch');
    await reload(page);
    assert.deepEqual(await heard(page), { lang: 'de', dir: 'ltr' });
    assert.equal(await page.locator('.hero h2').innerText(), german['Draw a line. Get a solid.']);
    await openWithPart(page, tube.png, tube.middle);
    assert.equal(await page.locator('#bar-save').innerText(), german.Save);
    assert.ok((await page.locator('#status-end').innerText()).includes(german['1 part']));
    await page.locator('#bar-help').click();
    await page.getByRole('dialog', { name: german.Help }).locator('[data-command=language]').click();
    await page.locator('[role=menuitemradio][data-value=en]').click();
    await spoken(page, 'en');
    assert.equal(await page.locator('#bar-save').innerText(), 'Save');
  }));

for (const [locale, id] of Object.entries({ 'fr-CA': 'fr', 'ja-JP': 'ja', 'pt-BR': 'en' })) {
  test(`a browser that asks for ${locale} gets ${id}`, () =>
    onPage(kit, { alone: true, locale }, async (page) => {
      assert.equal((await heard(page)).lang, id);
      const text = await page.locator('#choose').innerText();
      assert.equal(text, id === 'en' ? 'Choose a picture' : words(id)['Choose a picture']);
    }));
}

test('ids, states and files are the same in every language, and errors are sentences of it', () =>
  onPage(kit, { alone: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const before = await page.evaluate(() => [window.spineloft.state(), window.spineloft.commands()]);
    await speak(page, 'de');
    const [state, commands] = await page.evaluate(() => [window.spineloft.state(), window.spineloft.commands()]);
    // Where a control lies follows the length of its words, and new words are drawn.
    const placeless = ({ controls, frames, ...rest }) => rest;
    assert.deepEqual(placeless(state), placeless(before[0]));
    const plain = (list) => list.map(({ id, label, hint }) => [id, label, hint]);
    assert.deepEqual(plain(commands), plain(before[1]));
    const { code, message } = await page.evaluate(() =>
      window.spineloft.run('draw-spine', { stroke: [[1, 1]] }).then(
        () => ({}),
        ({ code, message }) => ({ code, message }),
      ),
    );
    assert.equal(code, 'StrokeTooShort');
    assert.equal(message, german['That line is too short. Draw a longer line along the middle of the object.']);
  }));

test('on a phone what comes next moves nothing, however long its words are in a language', () =>
  onPage(kit, { ...kPhone, locale: 'de' }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const says = [...readFileSync(join(root, 'web/shell/tasks.ts'), 'utf8').matchAll(/say: '([^']+)'/g)];
    assert.ok(says.length > 15);
    const texts = says.flatMap(([, say]) => [say, ...['de', 'fr', 'es', 'ja', 'ar'].map((id) => words(id)[say])]);
    const measured = await page.evaluate((all) => {
      const line = document.getElementById('coach-words'),
        box = () => document.querySelector('footer').getBoundingClientRect();
      line.textContent = '…';
      const before = box().height;
      return all.map((text) => {
        line.textContent = `${text} (3 / 5)`;
        const at = line.getBoundingClientRect();
        return { text, grown: box().height - before, fits: at.top >= box().top - 1 && at.bottom <= box().bottom + 1 };
      });
    }, texts);
    assert.deepEqual(
      measured.filter(({ grown, fits }) => grown !== 0 || !fits),
      [],
    );
  }));

test('on a phone Undo is whole in every language; words on other buttons give way', () =>
  onPage(kit, kPhone, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    for (const id of ['de', 'fr', 'es', 'ja', 'ar', 'en']) {
      await speak(page, id);
      const cut = await page.evaluate(() => {
        const box = document.getElementById('bar-items').getBoundingClientRect();
        return [...document.querySelectorAll('#bar-items button')]
          .filter((button) => button.offsetWidth > 0)
          .map((button) => [button.dataset.command, button.getBoundingClientRect()])
          .filter(([, at]) => at.left < box.left - 1 || at.right > box.right + 1)
          .map(([command]) => command);
      });
      assert.deepEqual(cut, [], id);
      assert.equal(await page.locator('#bar-items [data-command=undo]').isVisible(), true, id);
    }
  }));

test('from the right to the left the arrow of a line that leads to others points left, and so does its key', () =>
  onPage(kit, { alone: true, locale: 'ar' }, async (page) => {
    await spoken(page, 'ar');
    await openWithPart(page, tube.png, tube.middle);
    await page.locator('#bar-more').click();
    const leading = page.locator('.menu [aria-haspopup=menu]').first();
    const turned = await leading.locator('.leads-on').evaluate((arrow) => getComputedStyle(arrow).transform);
    assert.match(turned, /^matrix\(-1, 0, 0, 1,/);
    await leading.focus();
    await page.keyboard.press('ArrowLeft');
    await page.locator('.menu [role=menuitemradio]').first().waitFor();
  }));

test('the names of the animals stay on their tiles in every language', () =>
  onPage(kit, { ...kPhone, alone: true }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    for (const id of ['en', 'de', 'fr', 'es', 'ja', 'ar']) {
      await speak(page, id);
      await run(page, 'next-pupil');
      await page.locator('.animal').first().waitFor();
      const wide = await page
        .locator('.animal')
        .evaluateAll((tiles) =>
          tiles.filter((tile) => tile.scrollWidth > tile.clientWidth).map((tile) => tile.innerText),
        );
      assert.deepEqual(wide, [], id);
      await page.keyboard.press('Escape');
      await page.locator('.animal').first().waitFor({ state: 'detached' });
    }
  }));

test('a model that nobody has named is called so in the language of the page', () =>
  onPage(kit, { alone: true, locale: 'de' }, async (page) => {
    await spoken(page, 'de');
    await done(page, 'new-sketch');
    await done(page, 'draw-spine', { stroke: [40, 60, 80].map((x) => [x, 60]) });
    await done(page, 'new-model');
    const card = page.locator('#models-cards .model-name');
    await card.waitFor();
    assert.equal(await card.innerText(), german.Model);
  }));

test('on a phone the button of what is said holds its words in every language', () =>
  onPage(kit, { ...kPhone, locale: 'de' }, async (page) => {
    await openWithPart(page, tube.png, tube.middle);
    const aside = [30, 60, 90].map((x) => [x, 20]);
    await run(page, 'draw-spine', { stroke: aside });
    const button = page.locator('.toast-action');
    await button.waitFor();
    const texts = ['de', 'fr', 'es', 'ja', 'ar'].map((id) => words(id)['Try again']);
    const cut = await button.evaluate(
      (element, all) =>
        all.filter((text) => {
          element.textContent = text;
          return element.scrollWidth > element.clientWidth;
        }),
      texts,
    );
    assert.deepEqual(cut, []);
  }));

test('Arabic is written from the right, with letters that its fonts have', () =>
  onPage(kit, { alone: true, ...kSizes.desktop }, async (page) => {
    await speak(page, 'ar');
    assert.deepEqual(await heard(page), { lang: 'ar', dir: 'rtl' });
    const box = await page.locator('#home').boundingBox();
    assert.ok(box.x > 720, 'the bar begins at the right');
    assert.equal(await page.locator('#choose').innerText(), arabic['Choose a picture']);
    assert.ok(await page.evaluate(() => document.fonts.check('16px "SpineLoft Script ar"', 'عربي')));
    await speak(page, 'en');
    assert.deepEqual(await heard(page), { lang: 'en', dir: 'ltr' });
    assert.ok((await page.locator('#home').boundingBox()).x < 720);
  }));

test('in another language nothing is said in English', () =>
  onPage(kit, { alone: true, firstVisit: true, ...kSizes.desktop }, async (page) => {
    // What has a word of the catalogue is marked; arguments are in brackets.
    await replaceGerman(page, (text) => `«${text.replace(/[«»]/g, '').replace(/\{(\w+)\}/g, '»{$1}«')}»`);
    await speak(page, 'de');
    for (const [name, enter] of kStates) {
      await enter(page);
      await idle(page);
      await framed(page);
      const plain = await page.evaluate(() => {
        const isApart = (element) =>
          element.closest('kbd, .sample-credit, .noscript, #language, [data-command=language]');
        const found = [];
        const look = (text, element) => {
          // What is left without the words of the catalogue, numbers and names that were typed.
          const rest = text.replace(/«[^«»]*»/g, ' ').replace(/\b(SpineLoft|tube(\.png)?|KB|MB|AM|PM|\d+:\d+)\b/g, ' ');
          if (/\p{L}{2}/u.test(rest) && !isApart(element)) found.push(text);
        };
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (walker.nextNode()) {
          const { currentNode: node } = walker;
          const element = node.parentElement;
          if (!element.closest('script, style') && element.checkVisibility()) look(node.data, element);
        }
        for (const attribute of ['aria-label', 'title', 'placeholder', 'alt'])
          for (const element of document.querySelectorAll(`body [${attribute}]`))
            if (element.checkVisibility()) look(element.getAttribute(attribute), element);
        return found;
      });
      assert.deepEqual(plain, [], name);
    }
  }));

/** Letters of words 40 % more; what stands in braces stays. */
const longer = (text) =>
  text.replace(/\{\w+\}|\p{L}+/gu, (word) =>
    word.startsWith('{') ? word : word + word.slice(-1).repeat(Math.ceil(0.4 * word.length)),
  );

for (const [size, context] of sample(Object.entries(kSizes), 2)) {
  test(`with words 40 % longer nothing is cut off or lies on something else (${size})`, () =>
    onPage(kit, { alone: true, firstVisit: true, ...context }, async (page) => {
      await replaceGerman(page, longer);
      await speak(page, 'de');
      for (const [name, enter] of kStates) {
        await enter(page);
        await idle(page);
        await framed(page);
        const faults = await page.evaluate(() => {
          const out = [];
          const shown = [...document.body.querySelectorAll('*')].filter(
            (element) =>
              element.checkVisibility({ opacityProperty: true }) &&
              !element.closest('svg, .visually-hidden') &&
              getComputedStyle(element).clipPath !== 'inset(50%)', // only heard
          );
          const own = (element) => [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
          const nameOf = (element) => `${element.id || element.className || element.tagName}: ${element.innerText}`;
          for (const element of shown) {
            const box = element.getBoundingClientRect();
            if (box.width === 0 || !own(element)) continue;
            if (box.left < -1 || box.right > innerWidth + 1) out.push(`outside: ${nameOf(element)}`);
            const cuts = getComputedStyle(element).overflowX !== 'visible';
            if (cuts && element.scrollWidth > element.clientWidth + 1) out.push(`cut: ${nameOf(element)}`);
          }
          const buttons = shown.filter((element) => element.matches('button, [role=menuitem], [role=option]'));
          const top = (element) => {
            const box = element.getBoundingClientRect();
            return document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
          };
          const seen = buttons.filter((button) => button.contains(top(button)));
          for (const [i, a] of seen.entries())
            for (const b of seen.slice(i + 1)) {
              const [p, q] = [a.getBoundingClientRect(), b.getBoundingClientRect()];
              const wide = Math.min(p.right, q.right) - Math.max(p.left, q.left);
              const high = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
              if (wide > 1 && high > 1 && !a.contains(b) && !b.contains(a) && !a.parentElement.contains(b))
                out.push(`on each other: ${nameOf(a)} | ${nameOf(b)}`);
            }
          if (document.documentElement.scrollWidth > innerWidth + 1) out.push('the page is wider than the window');
          return out;
        });
        assert.deepEqual(faults, [], name);
      }
    }));
}
