// What belongs to this tab and outlives a reload. A browser that forbids it simply forgets.

const kPrefix = 'spineloft-';

/** The text under this key, or null. */
export function recall(key: string): string | null {
  try {
    return sessionStorage.getItem(kPrefix + key);
  } catch {
    return null;
  }
}

export function remember(key: string, text: string): void {
  try {
    sessionStorage.setItem(kPrefix + key, text);
  } catch {
    // Blocked storage: the start page says so when there is something to lose.
  }
}

/** A name of this tab that a reload keeps. A duplicated tab gets one of its own: it is only left behind on leaving. */
export function tabName(): string {
  const name = recall('tab') || Math.random().toString(36).slice(2);
  remember('tab', '');
  window.addEventListener('pagehide', () => remember('tab', name));
  return name;
}
