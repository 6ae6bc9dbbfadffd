// Style sheets follow the size of text that the browser asks for.
import assert from 'node:assert/strict';
import test from 'node:test';
import { followingText } from '../lib/site.mjs';

test('pixels become shares of the text, in the conditions of media queries too; names, colours and other units stay', () => {
  assert.equal(
    followingText(
      '.a1px{width:8px;margin:-4px .5px;inset:calc(100% - 24px)}@media (max-width:700px){b{top:16px;color:#12px}}',
    ),
    '.a1px{width:0.5rem;margin:-0.25rem 0.03125rem;inset:calc(100% - 1.5rem)}@media (max-width:43.75em){b{top:1rem;color:#12px}}',
  );
});
