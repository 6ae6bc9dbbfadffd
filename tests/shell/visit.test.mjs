// What leads a newcomer, without a browser: the search over commands, and the steps of tasks.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { root } from '../../.ci/lib/paths.mjs';
import { load } from './support/load.mjs';

const { choicesOf, findCommands } = await load('find_commands.ts');
const { kFirstVisit, kTasks, Steps } = await load('tasks.ts');
const { adviceFor } = await load('advice.ts');
const { exampleOn } = await load('task_drawings.ts');
const { isBlank } = await load('shell_view.ts');

const documented = JSON.parse(readFileSync(join(root, 'assets/docs/commands.json'), 'utf8'));
const commands = documented.map((row) => ({ ...row, icon: '', enabled: true }));

test('every command is found by its label, and before all that only mention the words', () => {
  for (const { id, label } of commands) {
    const found = findCommands(commands, label);
    assert.ok(
      found.some(({ command }) => command.id === id),
      `${id}: ${label}`,
    );
    assert.equal(found[0].label.toLowerCase().startsWith(label.toLowerCase().split(/[^\p{L}]/u)[0]), true, label);
  }
});

test('the search keeps the order of the table where nothing is typed, and finds nothing for what is nowhere', () => {
  assert.deepEqual(
    findCommands(commands, '').map(({ command }) => command.id),
    commands.map(({ id }) => id),
  );
  assert.deepEqual(findCommands(commands, 'qqxyzzy'), []);
});

test('more words find less; what can be run stands first among equals; choices are found by their own words', () => {
  const table = [
    { id: 'a', label: 'Save picture', hint: 'Of the solid', enabled: false },
    { id: 'b', label: 'Save model', hint: 'A file', enabled: true },
    {
      id: 'c',
      label: 'Slice',
      enabled: true,
      argument: { key: 'section', choices: [{ value: 'star', label: 'Star' }] },
    },
    { id: 'e', label: 'Start over', enabled: true },
    { id: 'd', label: 'Saved by numbers', enabled: true, argument: { key: 'x', kind: 'api' } },
  ];
  const ids = (query) => findCommands(table, query).map(({ command }) => command.id);
  assert.deepEqual(ids('save'), ['b', 'a']);
  assert.deepEqual(ids('save pic'), ['a']);
  assert.deepEqual(findCommands(table, 'star')[0].args, { section: 'star' }, 'a whole word before the start of one');
  assert.deepEqual(ids(''), ['b', 'c', 'e', 'a'], 'what only programs give is left out');
  assert.equal(findCommands(table, '')[1].leads, true);
});

test('the words of a command find one line that leads to its choices; of the same worth those of the menus come first', () => {
  const choices = ['At the top', 'In front', 'Open'].map((label) => ({ value: label, label }));
  const table = [
    { id: 'a', label: 'Make it open', enabled: true },
    { id: 'b', label: 'Opening', enabled: true, argument: { key: 'at', choices } },
    { id: 'c', label: 'Open picture', enabled: true },
    { id: 'd', label: 'Open file', enabled: true, menu: 'Model' },
  ];
  const labels = (query) => findCommands(table, query).map(({ label }) => label);
  assert.deepEqual(labels('opening'), ['Opening']);
  assert.deepEqual(labels('open'), ['Open file', 'Open picture', 'Make it open', 'Opening: Open', 'Opening']);
  assert.deepEqual(labels('top'), ['Opening: At the top']);
  assert.equal(findCommands(table, 'opening')[0].leads, true);
  assert.deepEqual(
    choicesOf(table[1]).map(({ args }) => args.at),
    ['At the top', 'In front', 'Open'],
  );
});

const kNothing = {
  parts: 0,
  solids: 0,
  hollow: 0,
  mirrored: 0,
  shaped: 0,
  turned: false,
  checked: false,
  unsaved: false,
  picture: { finished: false },
};
/** Everything that any step waits for. */
const kAll = {
  ...kNothing,
  parts: 9,
  solids: 9,
  hollow: 9,
  mirrored: 9,
  shaped: 9,
  turned: true,
  checked: true,
  picture: { finished: true },
};

for (const { id, steps } of [{ id: 'the first visit', steps: kFirstVisit }, ...kTasks]) {
  test(`${id}: no step is done before it begins, all can be done, and what was done stays done`, () => {
    for (const step of steps) {
      assert.equal(step.done(kNothing, kNothing), false, step.say);
      assert.equal(step.done(kAll, kNothing), true, step.say);
    }
    const led = new Steps(steps, kNothing);
    assert.equal(led.next(kNothing), steps[0]);
    assert.equal(led.next(kAll), null);
    assert.equal(led.next(kNothing), null);
  });
}

test('a step that is done out of order is not asked for again', () => {
  const led = new Steps(kFirstVisit, { ...kNothing, parts: 1, unsaved: true });
  assert.equal(led.next({ ...kNothing, parts: 2, unsaved: true }), kFirstVisit[0]);
  const after = led.next({ ...kNothing, parts: 2, unsaved: true, turned: true, shaped: 1 });
  assert.notEqual(after, kFirstVisit[2], 'the second part is there already');
  assert.equal(after, kFirstVisit[3]);
});

test('a step that the selected part cannot do waits, and the next one is told', () => {
  const led = new Steps(kFirstVisit, { ...kNothing, parts: 1 });
  const turned = { ...kNothing, parts: 1, turned: true };
  assert.equal(led.next({ ...turned, selected: { kind: 'loft' } }), kFirstVisit[1]);
  assert.equal(led.next({ ...turned, selected: { kind: 'lathe' } }), kFirstVisit[2]);
  assert.equal(led.next({ ...turned, selected: null }), kFirstVisit[1], 'the next part has a slice');
  assert.equal(led.next({ ...kAll, shaped: 0, selected: { kind: 'lathe' } }), null);
  assert.equal(led.areDone, false, 'it is told once it can be done');
});

test('the number that is told with a step is its place in the list, whatever was done before it', () => {
  for (const { steps } of [{ steps: kFirstVisit }, ...kTasks]) {
    const led = new Steps(steps, kNothing);
    steps.forEach((step, i) => assert.equal(led.place(step), i + 1));
  }
  const led = new Steps(kFirstVisit, { ...kNothing, parts: 1, unsaved: true });
  const first = led.next({ ...kNothing, parts: 2, shaped: 1, unsaved: true });
  assert.equal(led.place(first), 1, 'two later steps are done');
});

const kExamples = kTasks.flatMap(({ steps }) => steps.flatMap(({ examples = [] }) => examples));

test('every step of a task on paper that is drawn has an example, the first one on empty paper', () => {
  for (const { id, steps } of kTasks.filter(({ on }) => on === 'paper')) {
    const drawn = steps.filter(({ say }) => /draw/i.test(say));
    for (const { say, examples } of drawn) assert.ok(examples?.length > 0, `${id}: ${say}`);
    drawn.flatMap(({ examples }) => examples).forEach(({ on }, i) => assert.equal(on === null, i === 0, id));
  }
  const limbs = kTasks.find(({ id }) => id === 'robot').steps.find(({ examples }) => examples?.length > 1);
  assert.equal(limbs.examples.length, 3, 'head, arms and legs');
});

test('what the ghost hand draws stays on the paper, whose sides are as 3 to 4 or longer', () => {
  for (const { line } of kExamples)
    for (const [x, y] of line) assert.ok(Math.max(Math.abs(x), Math.abs(y)) < 0.45, `${x} ${y}`);
});

test('a later line goes with what was drawn first: to where it is, and as wide and high; never off the paper', () => {
  const paper = { width: 1200, height: 900, drawn: null };
  for (const example of kExamples) {
    if (example.on === null) {
      assert.deepEqual(
        exampleOn(example, paper),
        example.line.map(([x, y]) => [600 + 900 * x, 450 + 900 * y]),
      );
      assert.equal(exampleOn(example, { ...paper, drawn: [1, 2, 3, 4] }), null, 'something is there already');
      continue;
    }
    assert.equal(exampleOn(example, paper), null, 'nothing to draw it on');
    const first = exampleOn({ line: example.on, on: null }, paper);
    const [xs, ys] = [0, 1].map((k) => first.map((point) => point[k]));
    const drawn = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    const near = (a, b) => a.forEach((point, i) => point.forEach((v, k) => assert.ok(Math.abs(v - b[i][k]) < 1e-6)));
    const alike = exampleOn(example, { ...paper, drawn });
    near(alike, exampleOn({ line: example.line, on: null }, paper));
    const half = exampleOn(example, { ...paper, drawn: drawn.map((v) => 100 + v / 2) });
    near(
      half,
      alike.map((point) => point.map((v) => 100 + v / 2)),
    );
    for (const [x, y] of exampleOn(example, { ...paper, drawn: [0, 0, 1200, 900] }))
      assert.ok(x > 0 && x < 1200 && y > 0 && y < 900);
  }
});

test('advice is of the tool in hand: none where another tool says what it does', () => {
  const paper = { sketch: true, strokes: 0, finished: false };
  const at = (tool, picture) => adviceFor({ picture, parts: 0, penMenu: false, tool });
  const drawn = { ...paper, strokes: 1, finished: true };
  assert.match(at('pen', paper), /outline/);
  assert.match(at('pen', drawn), /Take Line/);
  assert.equal(at('draw', drawn), '', 'the tools are offered beside the drawing');
  assert.match(at('draw', { ...paper, sketch: false }), /middle/);
  for (const tool of ['puff', 'sheet', 'spin', 'layers', 'shapes', 'lines', 'hand', 'bone', 'move'])
    for (const picture of [paper, drawn, { ...paper, sketch: false }]) assert.equal(at(tool, picture), '', tool);
  assert.equal(adviceFor({ picture: paper, parts: 1, penMenu: false, tool: 'pen' }), '');
});

test('a board is blank with one sheet of paper and nothing on it', () => {
  const blank = { parts: 0, pictures: 1, picture: { sketch: true, strokes: 0 } };
  assert.equal(isBlank(blank), true);
  for (const more of [{ parts: 1 }, { pictures: 2 }, { picture: { sketch: true, strokes: 1 } }])
    assert.equal(isBlank({ ...blank, ...more }), false);
  assert.equal(isBlank({ ...blank, picture: { sketch: false, strokes: 0 } }), false, 'a photo');
  assert.equal(isBlank({ ...blank, pictures: 0, picture: null }), false, 'nothing was begun');
});
