// The module that is loaded when a server is used: encryption, the join words, the server's protocol and what waits.
// Others take types alone from these files, so that the page itself stays small.
export { keyOfWords, newId, newWords, readWords, seal, unseal } from './cipher.ts';
export { newStoredModel, Room, ServerFailure, ShareServer } from './client.ts';
export { Outbox } from './outbox.ts';
export { unzipSync, zipSync } from 'fflate';
