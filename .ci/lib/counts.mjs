// Reading how many tests passed, failed and were skipped from what the runners print. A runner that crashed, or ran
// nothing, failed.

export const nothing = { passed: 0, failed: 0, skipped: 0, note: '' };

function outcome({ passed, failed, skipped = 0 }, status, what) {
  if (passed + failed + skipped === 0) {
    const why = status === 0 ? 'ran no test' : `ended with exit code ${status} before its summary`;
    return { ...nothing, failed: 1, note: `${what} ${why}` };
  }
  if (status !== 0 && failed === 0)
    return { passed, failed: 1, skipped, note: `${what} ended with exit code ${status}` };
  return { passed, failed, skipped, note: '' };
}

/** How many test cases doctest's `--count` announces; 0 if it says nothing. */
export function doctestTotal(text) {
  return Number(text.match(/unskipped test cases passing the current filters: (\d+)/)?.[1] ?? 0);
}

/** `total` test cases, numbered from 1, in at most `count` stretches of nearly the same length. */
export function testStretches(total, count) {
  const parts = Math.max(1, Math.min(total, count));
  const upTo = (k) => Math.round((total * k) / parts);
  return Array.from({ length: parts }, (_, k) => ({ first: upTo(k) + 1, last: upTo(k + 1) }));
}

/** doctest's summary: `[doctest] test cases: 6 | 6 passed | 0 failed | 0 skipped`. */
export function doctestCounts({ text, status }) {
  return outcome(doctestSummary(text), status, 'the test program');
}

/** The same for a run over a stretch of `length` test cases: doctest counts all those outside it as passed. */
export function stretchCounts({ text, status }, length) {
  const { passed, failed } = doctestSummary(text);
  return outcome({ passed: passed + failed ? length - failed : 0, failed }, status, 'the test program');
}

function doctestSummary(text) {
  const plain = text.replace(/\x1b\[[0-9;]*m/g, '');
  const hit = plain.match(/\[doctest\] test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed/);
  return { passed: hit ? Number(hit[1]) : 0, failed: hit ? Number(hit[2]) : 0 };
}

export function sumCounts(results) {
  const sum = (key) => results.reduce((total, counts) => total + counts[key], 0);
  const notes = [...new Set(results.map((counts) => counts.note).filter(Boolean))];
  return { passed: sum('passed'), failed: sum('failed'), skipped: sum('skipped'), note: notes.join('; ') };
}

/** `9 passed, 0 failed`, and `, 2 skipped` where there are any. */
export function countsLine({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ''}`;
}

/** node:test's TAP summary: `# pass 9`, `# fail 0`, `# cancelled 0`, `# skipped 1`. */
export function nodeTestCounts({ text, status }) {
  const count = (key) => Number(text.match(new RegExp(`^# ${key} (\\d+)$`, 'm'))?.[1] ?? 0);
  const counts = { passed: count('pass'), failed: count('fail') + count('cancelled'), skipped: count('skipped') };
  return outcome(counts, status, 'node --test');
}
