"use strict";
// Asks the worker, one request at a time. Of several requests of one kind that wait, the last is what counts.

class Simulator {
  /** A run that is no longer wanted is broken off after so long, ms. */
  static PATIENCE = 250;

  constructor(module, source) {
    this.module = module;
    this.source = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.waiting = new Map();
    this.asked = null;
    this.number = 0;
    this.start();
  }

  start() {
    this.worker = new Worker(this.source);
    this.worker.onmessage = ({ data }) => this.take(data);
    this.worker.postMessage({ module: this.module });
  }

  /** Asks; `key` says of what kind. The answer, or null if another request of the kind came after it. What there is to show
      before the answer is whole goes to `early`. */
  ask(key, request, file, early = () => {}) {
    return new Promise(answer => {
      this.waiting.get(key)?.answer(null);
      this.waiting.set(key, { key, request, file, early, answer });
      if (this.asked?.key === key && performance.now() - this.asked.since > Simulator.PATIENCE) this.stop();
      this.giveWay();
      this.next();
    });
  }

  /** What has been shown gives way to a later request of its kind, and its rest is not awaited. */
  giveWay() {
    if (!this.asked?.isShown || !this.waiting.has(this.asked.key)) return;
    this.asked.answer(null);
    this.asked = null;
  }

  /** Nothing of this kind is wanted any more: what waits is not begun, and what runs gives room. */
  leave(key) {
    this.waiting.get(key)?.answer(null);
    this.waiting.delete(key);
    if (this.asked?.key === key) this.stop();
  }

  /** Breaks off what runs. */
  stop() {
    this.worker.terminate();
    this.start();
    this.asked?.answer(null);
    this.asked = null;
    this.next();
  }

  next() {
    const [first] = this.waiting.values();
    if (this.asked || !first) return;
    this.waiting.delete(first.key);
    const number = ++this.number;
    this.asked = { ...first, since: performance.now(), number };
    this.worker.postMessage({ number, request: first.request, file: first.file });
    // While it runs, a later one of its kind may have to break it off.
    setTimeout(() => { if (this.asked?.number === number && this.waiting.has(first.key)) this.stop(); }, Simulator.PATIENCE);
  }

  take({ number, answer, broken }) {
    if (number !== this.asked?.number) return;
    const { answer: tell, early } = this.asked;
    if (answer.more) {
      this.asked.isShown = true;
      early(answer);
      this.giveWay();
      this.next();
      return;
    }
    this.asked = null;
    if (broken) {
      this.worker.terminate();
      this.start();
    }
    // What came after it is of more use; this is shown meanwhile.
    tell(answer);
    this.next();
  }
}
