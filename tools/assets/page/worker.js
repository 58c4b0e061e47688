// The worker: simulates, so that the page never waits.
let kernel = null;
onmessage = async ({ data: { module, number, request, file } }) => {
  if (module) {
    kernel = startKernel(module);
    return;
  }
  try {
    const answer = (await kernel)(request, file);
    postMessage({ number, answer: answer.section ? unpack(answer) : answer });
  } catch (error) {
    // After a panic or without memory the instance is no good any more.
    postMessage({ number, answer: { failed: String(error.message) }, broken: true });
  }
};
