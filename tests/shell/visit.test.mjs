// What leads a newcomer, without a browser: the search over commands, and the steps of tasks.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { root } from '../../.ci/lib/paths.mjs';
import { load } from './support/load.mjs';

const { findCommands } = await load('find_commands.ts');
const { kFirstVisit, kTasks, Steps } = await load('tasks.ts');

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
    assert.deepEqual(led.count, { done: steps.length, all: steps.length });
  });
}

test('a step that is done out of order is not asked for again', () => {
  const led = new Steps(kFirstVisit, { ...kNothing, parts: 1, unsaved: true });
  assert.equal(led.next({ ...kNothing, parts: 2, unsaved: true }), kFirstVisit[0]);
  const after = led.next({ ...kNothing, parts: 2, unsaved: true, turned: true, shaped: 1 });
  assert.notEqual(after, kFirstVisit[2], 'the second part is there already');
  assert.equal(after, kFirstVisit[3]);
});
