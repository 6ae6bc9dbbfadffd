// Whether the views show all tools or those of a first visit: remembered by this browser.
const kKey = 'spineloft.tools';
const kAll = 'all';

export function wantsAllTools(): boolean {
  try {
    return localStorage.getItem(kKey) === kAll;
  } catch {
    return false; // a browser that keeps nothing
  }
}

/** Keeps what the visitor chooses, once the page shows what was kept before. */
export class ToolChoice {
  private wanted = wantsAllTools();
  private isShown = false;

  see(all: boolean): void {
    this.isShown ||= all === this.wanted;
    if (!this.isShown || all === this.wanted) return;
    this.wanted = all;
    try {
      if (all) localStorage.setItem(kKey, kAll);
      else localStorage.removeItem(kKey);
    } catch {
      // The first tools are shown again next time.
    }
  }
}
