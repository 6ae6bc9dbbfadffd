// Reading how many tests passed and failed from what the runners print. A runner that crashed, or ran nothing, failed.

function outcome(passed, failed, status, what) {
  if (passed + failed === 0) {
    const why = status === 0 ? 'ran no test' : `ended with exit code ${status} before its summary`;
    return { passed: 0, failed: 1, note: `${what} ${why}` };
  }
  if (status !== 0 && failed === 0) return { passed, failed: 1, note: `${what} ended with exit code ${status}` };
  return { passed, failed, note: '' };
}

/** doctest's summary: `[doctest] test cases: 6 | 6 passed | 0 failed | 0 skipped`. */
export function doctestCounts({ text, status }) {
  const plain = text.replace(/\x1b\[[0-9;]*m/g, '');
  const hit = plain.match(/\[doctest\] test cases:\s*\d+ \|\s*(\d+) passed \|\s*(\d+) failed/);
  return outcome(hit ? Number(hit[1]) : 0, hit ? Number(hit[2]) : 0, status, 'the test program');
}

/** node:test's TAP summary: `# pass 9`, `# fail 0`, `# cancelled 0`. */
export function nodeTestCounts({ text, status }) {
  const count = (key) => Number(text.match(new RegExp(`^# ${key} (\\d+)$`, 'm'))?.[1] ?? 0);
  return outcome(count('pass'), count('fail') + count('cancelled'), status, 'node --test');
}
