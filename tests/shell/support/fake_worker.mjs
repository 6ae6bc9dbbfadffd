/** A worker that answers when it is told to. */
export class FakeWorker {
  asked = [];
  ended = false;
  postMessage(message) {
    this.asked.push(message);
  }
  terminate() {
    this.ended = true;
  }
}
