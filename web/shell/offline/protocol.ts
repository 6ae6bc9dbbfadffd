// What the page and its service worker say to each other.

/** Start this release: every page but the one that asks is closed. */
export interface WorkerRequest {
  type: 'use-now';
}
/** `begun` is false while another tab uses the release before. */
export interface WorkerAnswer {
  begun: boolean;
}

/** Where the system's share sheet sends files (site.webmanifest), and where they wait for the page. */
export const kSharePath = './share';
export const kSharedCache = 'spineloft-shared';
