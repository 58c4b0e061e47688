"use strict";
// The kernel, compiled to WebAssembly: requests and answers are objects. The page and its worker each have one.

/** The bytes of base64. */
function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** The kernel's module from its compressed base64. */
async function compileKernel(text) {
  const bytes = bytesOf(text.trim());
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/** What the kernel's standard library asks of a system (WASI preview 1): there are no files, arguments or variables. What it
    tells, which is why it panics, goes to `told`. */
function systemOf(module, memory, told) {
  const NOT_THERE = 52;
  const system = {
    environ_sizes_get(count, size) {
      const view = new DataView(memory().buffer);
      view.setUint32(count, 0, true);
      view.setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    /** For keys of hash tables, on which no result depends: what stands there will do. */
    random_get: () => 0,
    fd_write(file, parts, count, written) {
      const view = new DataView(memory().buffer);
      let length = 0;
      for (let i = 0; i < count; i++) {
        const [start, size] = [view.getUint32(parts + 8 * i, true), view.getUint32(parts + 8 * i + 4, true)];
        told.push(new TextDecoder().decode(new Uint8Array(memory().buffer, start, size).slice()));
        length += size;
      }
      view.setUint32(written, length, true);
      return 0;
    },
    proc_exit() { throw new Error("the kernel has ended"); },
  };
  for (const { name } of WebAssembly.Module.imports(module)) system[name] ??= () => NOT_THERE;
  return { wasi_snapshot_preview1: system };
}

/** An instance of the kernel: a function from a request, and the bytes of a file if one belongs to it, to the answer. */
async function startKernel(module) {
  let kernel = null;
  const told = [];
  kernel = (await WebAssembly.instantiate(module, systemOf(module, () => kernel.memory, told))).exports;
  kernel._initialize?.();
  const put = (bytes, room) => new Uint8Array(kernel.memory.buffer, room(bytes.length), bytes.length).set(bytes);
  const answer = () => {
    try {
      return kernel.softanvil_answer();
    } catch (error) {
      throw new Error(told.join("") || error.message);
    }
  };
  return (request, file) => {
    put(new TextEncoder().encode(JSON.stringify(request)), kernel.softanvil_request);
    if (file) put(file, kernel.softanvil_file);
    const length = answer();
    const bytes = new Uint8Array(kernel.memory.buffer, kernel.softanvil_answer_address(), length);
    return JSON.parse(new TextDecoder().decode(bytes));
  };
}

/** Makes numbers of what is packed in a drop. */
function unpack(drop) {
  for (const packed of drop.section ? [drop.section.displacement, ...drop.section.shades] : []) {
    packed.values = new Int16Array(bytesOf(packed.values).buffer);
  }
  return drop;
}
