// run_module.ts MODULE CASES RESULTS: runs the WebAssembly module, as the native program extract_everywhere does
// natively.
import { readFileSync, writeFileSync } from "node:fs";

interface Module {
  memory: WebAssembly.Memory;
  _initialize(): void;
  room_for_cases(size: number): number;
  extract(): number;
  results(): number;
}

const badFile = 8; // WASI's error EBADF

/** WASI functions for the module, which opens no file. It writes only the kernel's message before an abort. */
function wasi(memory: () => DataView): WebAssembly.ModuleImports {
  return {
    fd_close: () => badFile,
    fd_seek: () => badFile,
    fd_write: (_file: number, parts: number, count: number, written: number) => {
      const view = memory();
      let total = 0;
      for (let part = parts; part < parts + 8 * count; part += 8) {
        const size = view.getUint32(part + 4, true);
        process.stderr.write(new Uint8Array(view.buffer, view.getUint32(part, true), size));
        total += size;
      }
      view.setUint32(written, total, true);
      return 0;
    },
  };
}

function run(code: Uint8Array<ArrayBuffer>, cases: Uint8Array): Uint8Array {
  const module = new WebAssembly.Module(code);
  const instance = new WebAssembly.Instance(module, {
    wasi_snapshot_preview1: wasi(() => new DataView(exported.memory.buffer)),
  });
  const exported = instance.exports as unknown as Module;
  exported._initialize();
  const room = exported.room_for_cases(cases.length);
  new Uint8Array(exported.memory.buffer, room, cases.length).set(cases);
  const size = exported.extract();
  return new Uint8Array(exported.memory.buffer, exported.results(), size);
}

const [module, cases, results] = process.argv.slice(2);
if (!module || !cases || !results) throw new Error("run_module.ts: give the module, the cases and the file to write");
writeFileSync(results, run(new Uint8Array(readFileSync(module)), readFileSync(cases)));
