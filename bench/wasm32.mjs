// Times the golden scenes in a program for wasm32-wasip1, with each of its instruction sets by turns; the fastest counts.
//
//     node wasm32.mjs PROGRAM
import { readFile } from 'node:fs/promises';
import { devNull } from 'node:os';
import { openSync } from 'node:fs';
import { WASI } from 'node:wasi';

const turns = 20;
const program = process.argv[2];
const module = await WebAssembly.compile(await readFile(program));
const silence = openSync(devNull, 'w');

// Seconds of a check of every scene, which must succeed.
async function seconds(set) {
  const wasi = new WASI({ version: 'preview1', args: [program, '--instructions', set, 'check'], stdout: silence, returnOnExit: true });
  const instance = await WebAssembly.instantiate(module, wasi.getImportObject());
  const start = performance.now();
  if (wasi.start(instance) !== 0) throw new Error(`${set}: other digests, or no such set`);
  return (performance.now() - start) / 1e3;
}

const fastest = { baseline: Infinity, simd128: Infinity };
for (let turn = 0; turn < turns; turn++) {
  for (const set of Object.keys(fastest)) fastest[set] = Math.min(fastest[set], await seconds(set));
}
const { baseline, simd128 } = fastest;
console.log(`one number at a time ${baseline.toFixed(3)} s, simd128 ${simd128.toFixed(3)} s, ratio ${(baseline / simd128).toFixed(2)}`);
