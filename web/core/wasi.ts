// A small system for the command: its words, its files in memory, its output. What WASI asks and the command needs, and
// nothing else: no network, no other files, no other programs.

export const REPORT_SCRIPT = "usr/share/yoke/report.js"; // where the command looks for it (small/report_script.c)

export interface System {
  words: string[]; // after the name of the command
  files: Map<string, Uint8Array>; // by path; what the command writes is put here
  read?: (path: string) => Uint8Array | null; // further files, to be read only
  hear?: (bytes: Uint8Array) => void; // takes standard output as it is written, while the command runs
}

const OK = 0, BADF = 8, EXIST = 20, INVAL = 28, ISDIR = 31, NOENT = 44, NOSYS = 52, NOTEMPTY = 55, SPIPE = 70;
const REGULAR = 4, DIRECTORY = 3, CHARACTER = 2;
const CREATE = 1, ONLY_FOLDER = 2, EXCLUSIVE = 4, TRUNCATE = 8;

class Exit extends Error {
  constructor(readonly code: number) { super("exit"); }
}

interface Open { path: string; bytes: Uint8Array; length: number; at: number; writes: boolean; kind: number }

// Makes "a/b" of "./a//c/../b".
function tidy(path: string): string {
  const parts: string[] = [];
  for (const part of path.split("/")) {
    if (part === "..") parts.pop();
    else if (part !== "" && part !== ".") parts.push(part);
  }
  return parts.join("/");
}

const join = (pieces: Uint8Array[]): Uint8Array => {
  const whole = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let at = 0;
  for (const piece of pieces) {
    whole.set(piece, at);
    at += piece.length;
  }
  return whole;
};

class Wasi {
  private memory!: WebAssembly.Memory;
  private readonly open = new Map<number, Open>();
  private readonly folders = new Set<string>(["", "tmp"]);
  readonly output: Uint8Array[][] = [[], []]; // standard output, standard error
  private readonly words: Uint8Array[];
  private readonly environment: Uint8Array[];

  constructor(private readonly system: System) {
    const encode = (text: string) => new TextEncoder().encode(text + "\0");
    this.words = ["yoke", ...system.words].map(encode);
    this.environment = ["NO_COLOR=1", "TERM=dumb"].map(encode);
    const stream = (path: string): Open => ({ path, bytes: new Uint8Array(0), length: 0, at: 0, writes: true, kind: CHARACTER });
    for (let fd = 0; fd < 3; fd++) this.open.set(fd, stream(""));
    this.open.set(3, { ...stream(""), kind: DIRECTORY });
    for (const path of system.files.keys()) this.addFolders(tidy(path));
  }

  start(memory: WebAssembly.Memory): void {
    this.memory = memory;
  }

  private addFolders(path: string): void {
    for (let at = path.lastIndexOf("/"); at > 0; at = path.lastIndexOf("/", at - 1)) this.folders.add(path.slice(0, at));
  }

  private view(): DataView { return new DataView(this.memory.buffer); }
  private bytes(at: number, length: number): Uint8Array { return new Uint8Array(this.memory.buffer, at, length); }
  private path(at: number, length: number): string { return tidy(new TextDecoder().decode(this.bytes(at, length))); }

  private find(path: string): Uint8Array | null {
    for (const [name, bytes] of this.system.files) if (tidy(name) === path) return bytes;
    return this.system.read?.(path) ?? null;
  }

  private keep(path: string, bytes: Uint8Array): void {
    this.remove(path);
    this.system.files.set(path, bytes);
  }

  private remove(path: string): void {
    for (const name of this.system.files.keys()) if (tidy(name) === path) this.system.files.delete(name);
  }

  private strings(list: Uint8Array[], pointers: number, buffer: number): number {
    list.forEach((text, k) => {
      this.view().setUint32(pointers + 4 * k, buffer, true);
      this.bytes(buffer, text.length).set(text);
      buffer += text.length;
    });
    return OK;
  }

  private sizes(list: Uint8Array[], count: number, length: number): number {
    this.view().setUint32(count, list.length, true);
    this.view().setUint32(length, list.reduce((sum, text) => sum + text.length, 0), true);
    return OK;
  }

  private filestat(at: number, kind: number, size: number): number {
    this.bytes(at, 64).fill(0);
    this.view().setUint8(at + 16, kind);
    this.view().setBigUint64(at + 32, BigInt(size), true);
    return OK;
  }

  private write(file: Open, data: Uint8Array): void {
    const end = file.at + data.length;
    if (end > file.bytes.length) {
      const larger = new Uint8Array(Math.max(end, 2 * file.bytes.length));
      larger.set(file.bytes.subarray(0, file.length));
      file.bytes = larger;
    }
    file.bytes.set(data, file.at);
    file.at = end;
    file.length = Math.max(file.length, end);
    this.keep(file.path, file.bytes.subarray(0, file.length));
  }

  private vectors(at: number, count: number): Uint8Array[] {
    const view = this.view();
    return Array.from({ length: count }, (_, k) => this.bytes(view.getUint32(at + 8 * k, true), view.getUint32(at + 8 * k + 4, true)));
  }

  private pathOpen(at: number, length: number, oflags: number, writes: boolean, fd: number): number {
    const path = this.path(at, length);
    if (this.folders.has(path)) {
      if (writes) return ISDIR;
      return this.give({ path, bytes: new Uint8Array(0), length: 0, at: 0, writes: false, kind: DIRECTORY }, fd);
    }
    const found = this.find(path);
    if (oflags & ONLY_FOLDER) return NOENT;
    if (found && oflags & EXCLUSIVE) return EXIST;
    if (!found && !(oflags & CREATE)) return NOENT;
    const slash = path.lastIndexOf("/");
    if (!found && slash > 0 && !this.folders.has(path.slice(0, slash))) return NOENT;
    const bytes = found && !(oflags & TRUNCATE) ? found : new Uint8Array(0);
    if (!found || oflags & TRUNCATE) this.keep(path, bytes);
    return this.give({ path, bytes, length: bytes.length, at: 0, writes, kind: REGULAR }, fd);
  }

  private give(file: Open, fd: number): number {
    let number = 4;
    while (this.open.has(number)) number++;
    this.open.set(number, file);
    this.view().setUint32(fd, number, true);
    return OK;
  }

  imports(): Record<string, (...words: never[]) => number> {
    const file = (fd: number) => this.open.get(fd);
    return {
      args_get: (pointers: number, buffer: number) => this.strings(this.words, pointers, buffer),
      args_sizes_get: (count: number, length: number) => this.sizes(this.words, count, length),
      environ_get: (pointers: number, buffer: number) => this.strings(this.environment, pointers, buffer),
      environ_sizes_get: (count: number, length: number) => this.sizes(this.environment, count, length),
      clock_time_get: (_clock: number, _precision: bigint, at: number) => {
        this.view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
        return OK;
      },
      clock_res_get: (_clock: number, at: number) => {
        this.view().setBigUint64(at, 1000000n, true);
        return OK;
      },
      random_get: (at: number, length: number) => {
        crypto.getRandomValues(this.bytes(at, length) as Uint8Array<ArrayBuffer>);
        return OK;
      },
      sched_yield: () => OK,
      poll_oneoff: () => NOSYS,
      proc_exit: (code: number) => { throw new Exit(code); },
      fd_prestat_get: (fd: number, at: number) => {
        if (fd !== 3) return BADF;
        this.view().setUint32(at, 0, true);
        this.view().setUint32(at + 4, 1, true);
        return OK;
      },
      fd_prestat_dir_name: (_fd: number, at: number) => {
        this.bytes(at, 1)[0] = 0x2f;
        return OK;
      },
      fd_fdstat_get: (fd: number, at: number) => {
        const found = file(fd);
        if (!found) return BADF;
        this.bytes(at, 24).fill(0);
        this.view().setUint8(at, found.kind);
        this.view().setBigUint64(at + 8, 0xffffffffffffffffn, true);
        this.view().setBigUint64(at + 16, 0xffffffffffffffffn, true);
        return OK;
      },
      fd_fdstat_set_flags: () => OK,
      fd_filestat_get: (fd: number, at: number) => {
        const found = file(fd);
        return found ? this.filestat(at, found.kind, found.length) : BADF;
      },
      fd_filestat_set_size: (fd: number, size: bigint) => {
        const found = file(fd);
        if (!found) return BADF;
        found.length = Math.min(found.length, Number(size));
        this.keep(found.path, found.bytes.subarray(0, found.length));
        return OK;
      },
      fd_sync: () => OK,
      fd_close: (fd: number) => (this.open.delete(fd) ? OK : BADF),
      fd_seek: (fd: number, offset: bigint, whence: number, at: number) => {
        const found = file(fd);
        if (!found) return BADF;
        if (found.kind === CHARACTER) return SPIPE;
        const base = whence === 0 ? 0 : whence === 1 ? found.at : found.length, to = base + Number(offset);
        if (to < 0) return INVAL;
        found.at = to;
        this.view().setBigUint64(at, BigInt(to), true);
        return OK;
      },
      fd_tell: (fd: number, at: number) => {
        const found = file(fd);
        if (!found) return BADF;
        if (found.kind === CHARACTER) return SPIPE;
        this.view().setBigUint64(at, BigInt(found.at), true);
        return OK;
      },
      fd_read: (fd: number, vectors: number, count: number, at: number) => {
        const found = file(fd);
        if (!found) return BADF;
        let got = 0;
        for (const into of this.vectors(vectors, count)) {
          const piece = found.bytes.subarray(found.at, Math.min(found.at + into.length, found.length));
          into.set(piece);
          found.at += piece.length;
          got += piece.length;
        }
        this.view().setUint32(at, got, true);
        return OK;
      },
      fd_write: (fd: number, vectors: number, count: number, at: number) => {
        const found = file(fd);
        if (!found) return BADF;
        let done = 0;
        for (const data of this.vectors(vectors, count)) {
          if (fd < 3) this.output[fd === 2 ? 1 : 0].push(data.slice());
          else this.write(found, data);
          if (fd === 1 && data.length > 0) this.system.hear?.(data.slice());
          done += data.length;
        }
        this.view().setUint32(at, done, true);
        return OK;
      },
      fd_readdir: (_fd: number, _at: number, _length: number, _cookie: bigint, used: number) => {
        this.view().setUint32(used, 0, true);
        return OK;
      },
      path_open: (_fd: number, _flags: number, at: number, length: number, oflags: number, rights: bigint, _more: bigint,
        _fdflags: number, fd: number) => this.pathOpen(at, length, oflags, (rights & 64n) !== 0n, fd),
      path_filestat_get: (_fd: number, _flags: number, at: number, length: number, stat: number) => {
        const path = this.path(at, length), found = this.find(path);
        if (this.folders.has(path)) return this.filestat(stat, DIRECTORY, 0);
        return found ? this.filestat(stat, REGULAR, found.length) : NOENT;
      },
      path_create_directory: (_fd: number, at: number, length: number) => {
        const path = this.path(at, length);
        if (this.folders.has(path) || this.find(path)) return EXIST;
        this.folders.add(path);
        return OK;
      },
      path_remove_directory: (_fd: number, at: number, length: number) => {
        const path = this.path(at, length), inside = (name: string) => tidy(name).startsWith(path + "/");
        if ([...this.system.files.keys()].some(inside)) return NOTEMPTY;
        return this.folders.delete(path) ? OK : NOENT;
      },
      path_unlink_file: (_fd: number, at: number, length: number) => {
        const path = this.path(at, length);
        if (!this.find(path)) return NOENT;
        this.remove(path);
        return OK;
      },
      path_rename: (_fd: number, at: number, length: number, _other: number, to: number, toLength: number) => {
        const path = this.path(at, length), found = this.find(path);
        if (!found) return NOENT;
        this.remove(path);
        this.keep(this.path(to, toLength), found);
        return OK;
      },
    } as unknown as Record<string, (...words: never[]) => number>;
  }
}

// Runs the command once, as a program of its own. Bytes, so that tests can compare every one of them.
export function runCommand(module: WebAssembly.Module, system: System): { exit: number; out: Uint8Array; err: Uint8Array } {
  const wasi = new Wasi(system);
  const known = wasi.imports();
  const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: known as WebAssembly.ModuleImports });
  const program = instance.exports as unknown as { memory: WebAssembly.Memory; _initialize(): void; _start(): void };
  wasi.start(program.memory);
  let exit = 0;
  try {
    program._initialize();
    program._start();
  } catch (problem) {
    if (!(problem instanceof Exit)) throw problem;
    exit = problem.code;
  }
  return { exit, out: join(wasi.output[0]), err: join(wasi.output[1]) };
}

// Makes an instance whose functions are called one by one: of core.wasm, which imports nothing, or of panels.wasm, whose
// system then has no files.
export function instanceOf(module: WebAssembly.Module): WebAssembly.Exports {
  if (WebAssembly.Module.imports(module).length === 0) return new WebAssembly.Instance(module, {}).exports;
  const wasi = new Wasi({ words: [], files: new Map() });
  const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi.imports() as WebAssembly.ModuleImports });
  wasi.start(exports.memory as WebAssembly.Memory);
  return exports;
}
