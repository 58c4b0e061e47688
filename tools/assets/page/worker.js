// The worker: simulates, so that the page never waits.
let kernel = null, newest = 0;
const channel = new MessageChannel();
/** The rest of a drop begins so long after what is shown of it, ms: until then the page draws, and needs the processors. */
const WHILE_DRAWN = 30;
/** Lets in what has been asked meanwhile. */
const pause = () => new Promise(done => { channel.port1.onmessage = done; channel.port2.postMessage(null); });

onmessage = async ({ data: { module, number, request, file } }) => {
  if (module) {
    kernel = startKernel(module);
    return;
  }
  newest = number;
  try {
    let answer = (await kernel)(request, file);
    postMessage({ number, answer: answer.section ? unpack(answer) : answer });
    if (answer.more) await new Promise(done => setTimeout(done, WHILE_DRAWN));
    while (answer.more) {
      await pause();
      if (newest !== number) return;
      answer = (await kernel)({ kind: "rest" });
      if (!answer.more) postMessage({ number, answer: answer.section ? unpack(answer) : answer });
    }
  } catch (error) {
    // After a panic or without memory the instance is no good any more.
    postMessage({ number, answer: { failed: String(error.message) }, broken: true });
  }
};
