// The page as a screen reader has it: the browser's accessibility tree, and nothing else to find things by.
import assert from 'node:assert/strict';
import { idle } from './page.mjs';

/** `reader.find(role, name)`, `reader.press(role, name)`; names are exact or patterns. */
export async function readerOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Accessibility.enable');
  const nodes = async () => (await session.send('Accessibility.getFullAXTree')).nodes.filter((node) => !node.ignored);
  const fits = (name, wanted) => (wanted instanceof RegExp ? wanted.test(name) : name === wanted);
  const find = async (role, wanted) =>
    (await nodes()).filter((node) => node.role?.value === role && fits(node.name?.value ?? '', wanted));
  const property = (node, name) => node.properties?.find((one) => one.name === name)?.value.value;
  /** Calls a function of the element, as what assists does: no pointer goes anywhere. */
  const act = async (node, functionDeclaration, ...values) => {
    const { object } = await session.send('DOM.resolveNode', { backendNodeId: node.backendDOMNodeId });
    await session.send('Runtime.callFunctionOn', {
      objectId: object.objectId,
      functionDeclaration,
      arguments: values.map((value) => ({ value })),
    });
    await idle(page);
  };
  const one = async (role, wanted) => {
    // What the canvas shows is told when it is at rest.
    const until = Date.now() + 10_000;
    for (;;) {
      const found = await find(role, wanted);
      if (found.length > 0) return found[0];
      if (Date.now() > until) {
        const all = (await nodes()).filter((node) => node.role?.value === role).map((node) => node.name?.value);
        assert.fail(`no ${role} "${wanted}" among ${all.join(' | ')}`);
      }
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  };
  return {
    find,
    one,
    property,
    press: async (role, wanted) => act(await one(role, wanted), 'function () { this.click(); }'),
    focus: async (role, wanted) => act(await one(role, wanted), 'function () { this.focus(); }'),
    set: async (role, wanted, value) =>
      act(
        await one(role, wanted),
        'function (value) { this.value = value; this.dispatchEvent(new Event("change", { bubbles: true })); }',
        value,
      ),
    /** What the live region says now. */
    said: () => page.locator('#status').innerText(),
  };
}
