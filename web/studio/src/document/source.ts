// The machine's file as text that gestures edit: each edit changes the few characters it means and keeps every comment,
// order, column and number format around them. Immutable: an edit returns the text after it.
import { isMap, isScalar, LineCounter, parseDocument, visit } from "yaml";
import type { Document, Node, Pair, YAMLMap } from "yaml";

export interface Change { from: number; to: number; insert: string }
export type Path = readonly string[];

const LONGEST_LINE = 110;
const ORDER = ["name", "units", "parameters", "gravity", "laws", "bodies", "joints", "gears", "racks", "belts", "cams", "forces",
  "springs", "stops", "locks", "drives", "efforts", "start"];
const SHORT = new Set(["units", "parameters", "drives", "efforts", "start"]);

export const keyOf = (pair: Pair): string => (isScalar(pair.key) ? String(pair.key.value) : "");
const keyRange = (pair: Pair) => (pair.key as Node).range!;

export class Source {
  private parsed: Document | null = null;
  constructor(readonly text: string) {}

  // A text nested so deep that the parser runs out of stack is taken for one with mistakes.
  private parse(): Document {
    try {
      return parseDocument(this.text, { keepSourceTokens: true, lineCounter: new LineCounter(), strict: false, uniqueKeys: false });
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      return parseDocument("[");
    }
  }

  private get document(): Document {
    return (this.parsed ??= this.parse());
  }

  // Tells whether gestures may edit the text: YAML with mistakes in its syntax is mended by hand first.
  get isSound(): boolean {
    const contents = this.document.contents;
    return this.document.errors.length === 0 && (contents === null || isMap(contents) || (isScalar(contents) && contents.value === null));
  }

  node(path: Path): Node | null {
    let node: Node | null = this.document.contents;
    for (const key of path) {
      const pair = isMap(node) ? pairOf(node, key) : null;
      node = (pair?.value as Node | null) ?? null;
    }
    return node;
  }

  has(path: Path): boolean {
    const parent = this.node(path.slice(0, -1));
    return isMap(parent) && pairOf(parent, path[path.length - 1]) !== null;
  }

  keys(path: Path): string[] {
    const node = this.node(path);
    return isMap(node) ? node.items.map(keyOf) : [];
  }

  // Returns the characters of the value, as the file has them; null if there is none.
  value(path: Path): string | null {
    const node = this.node(path);
    return node?.range ? this.text.slice(node.range[0], endOf(node, node.range[1])) : null;
  }

  // Returns where the key stands, for the editor to go to; null if it is not there.
  place(path: Path): { from: number; to: number } | null {
    const parent = this.node(path.slice(0, -1)), pair = isMap(parent) ? pairOf(parent, path[path.length - 1]) : null;
    return pair ? { from: keyRange(pair)[0], to: pairEnd(pair) } : null;
  }

  // Calls `seen` with every word (scalar) below a path.
  words(path: Path, seen: (word: string) => void): void {
    const node = this.node(path);
    if (node) visit(node, { Scalar: (_, scalar) => seen(String(scalar.value)) });
  }

  // Sets the value at a path to text that is YAML already; adds what is missing on the way there.
  set(path: Path, value: string): Source {
    let depth = path.length;
    while (depth > 0 && !this.has(path.slice(0, depth))) depth--;
    const there = path.slice(0, depth), node = this.node(there);
    if (depth === path.length && node?.range && !(isScalar(node) && node.range[0] === node.range[1]))
      return this.splice(node.range[0], endOf(node, node.range[1]), value);
    const rest = path.slice(depth);
    if (isMap(node)) return this.add(node, rest, value, depth === 0);
    if (depth === 0) return this.addSection(rest, value);
    if (node === null || (isScalar(node) && node.value === null)) return this.fill(there, nested(rest, value));
    return this.splice(node.range![0], endOf(node, node.range![1]), nested(rest, value)); // a value where a map is needed
  }

  // Removes a key with its value, and a section of the file that is then empty.
  remove(path: Path): Source {
    const parent = this.node(path.slice(0, -1)), pair = isMap(parent) ? pairOf(parent, path[path.length - 1]) : null;
    if (!isMap(parent) || !pair) return this;
    if (parent.items.length === 1 && path.length === 2) return this.remove(path.slice(0, 1));
    const from = keyRange(pair)[0], to = pairEnd(pair), text = this.text;
    if (!parent.flow) {
      const start = text.lastIndexOf("\n", from - 1) + 1, end = text.indexOf("\n", to);
      return this.splice(start, end < 0 ? text.length : end + 1, "");
    }
    const index = parent.items.indexOf(pair), next = parent.items[index + 1], before = parent.items[index - 1];
    if (next) return this.splice(from, keyRange(next)[0], "");
    return before ? this.splice(pairEnd(before), to, "") : this.splice(from, to, "");
  }

  splice(from: number, to: number, insert: string): Source {
    return new Source(this.text.slice(0, from) + insert + this.text.slice(to));
  }

  private add(map: YAMLMap, path: Path, value: string, isRoot: boolean): Source {
    if (isRoot) return this.addSection(path, value);
    const [key, ...below] = path, inner = nested(below, value), last = map.items[map.items.length - 1];
    if (map.flow) {
      const entry = `${written(key)}: ${inner}`;
      if (!last) return this.splice(map.range![0], map.range![1], `{${entry}}`);
      const end = pairEnd(last), column = this.column(end);
      if (column + entry.length < LONGEST_LINE) return this.splice(end, end, `, ${entry}`);
      return this.splice(end, end, `,\n${" ".repeat(this.column(keyRange(map.items[0])[0]))}${entry}`);
    }
    const first = keyRange(map.items[0])[0], indent = this.column(first), end = this.lineEnd(pairEnd(last));
    if (key === "ground") return this.splice(first, first, `${this.padded(map, key)}${inner}\n${" ".repeat(indent)}`); // first, as people write it
    return this.splice(end, end, `\n${" ".repeat(indent)}${this.padded(map, key)}${inner}`);
  }

  // Returns "key: ", with blanks so that its value stands below the values beside it, where they all stand in one column.
  private padded(map: YAMLMap, key: string): string {
    const columns = new Set(map.items.map((pair) => {
      const value = pair.value as Node | null;
      return value?.range && this.line(value.range[0]) === this.line(keyRange(pair)[0]) ? this.column(value.range[0]) - this.column(keyRange(pair)[0]) : -1;
    }));
    const word = `${written(key)}: `, [width] = columns;
    return columns.size === 1 && map.items.length > 1 ? word.padEnd(width) : word;
  }

  // Adds a section to the root, before the first that comes after it in the usual order.
  private addSection(path: Path, value: string): Source {
    const [section, ...below] = path, root = this.document.contents, items = isMap(root) ? root.items : [];
    const inner = below.length === 0 ? ` ${value}` : SHORT.has(section) ? ` ${nested(below, value)}`
      : `\n  ${written(below[0])}: ${nested(below.slice(1), value)}`;
    const entry = `${written(section)}:${inner}`, rank = ORDER.indexOf(section);
    const after = [...items].reverse().find((pair) => rank < 0 || (ORDER.indexOf(keyOf(pair)) >= 0 && ORDER.indexOf(keyOf(pair)) < rank));
    if (isMap(root) && root.flow) return items.length ? this.splice(pairEnd(items[items.length - 1]), pairEnd(items[items.length - 1]), `, ${written(section)}: ${nested(below, value)}`)
      : this.splice(root.range![0], root.range![1], `{${written(section)}: ${nested(below, value)}}`);
    if (after) {
      const end = this.lineEnd(pairEnd(after));
      return this.splice(end, end, `\n${entry}`);
    }
    if (items.length) return this.splice(keyRange(items[0])[0], keyRange(items[0])[0], `${entry}\n`);
    const text = this.text === "" || this.text.endsWith("\n") ? this.text : this.text + "\n";
    return new Source(`${text}${entry}\n`);
  }

  // Writes the first value of a key that has none: `bodies:` with nothing behind it.
  private fill(path: Path, inner: string): Source {
    const place = this.place(path)!, colon = this.text.indexOf(":", place.from + path[path.length - 1].length);
    return this.splice(colon + 1, Math.max(place.to, colon + 1), ` ${inner}`);
  }

  private column(at: number): number {
    return at - (this.text.lastIndexOf("\n", at - 1) + 1);
  }
  private line(at: number): number {
    return this.text.lastIndexOf("\n", at - 1);
  }
  private lineEnd(at: number): number {
    const end = this.text.indexOf("\n", at);
    return end < 0 ? this.text.length : end;
  }
}

function pairOf(map: YAMLMap, key: string): Pair | null {
  return (map.items as Pair[]).find((pair) => keyOf(pair) === key) ?? null;
}

// Returns where a value ends: a block's range includes the blank lines and comments behind it, which are not its own.
function endOf(node: Node | null, otherwise: number): number {
  if (!node?.range) return otherwise;
  const collection = node as unknown as { items?: unknown[]; flow?: boolean };
  if (!collection.items || collection.flow || collection.items.length === 0) return node.range[1];
  const last = collection.items[collection.items.length - 1] as Pair | Node;
  return "key" in last ? pairEnd(last as Pair) : endOf(last as Node, node.range[1]);
}

function pairEnd(pair: Pair): number {
  const value = pair.value as Node | null, end = keyRange(pair)[1] + 1;
  return value?.range && value.range[1] > value.range[0] ? endOf(value, end) : end;
}

const nested = (path: Path, value: string): string => path.reduceRight((inner, key) => `{${written(key)}: ${inner}}`, value);

// Writes a key, or a word a person typed, so that YAML reads it as that word, also between braces.
export function written(word: string): string {
  if (/^[A-Za-z_][A-Za-z0-9_.'-]*$/.test(word) && !/^(true|false|null|yes|no|on|off)$/i.test(word)) return word;
  if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word)) return word;
  const document = parseDocument(`{k: ${word}}`), value = document.errors.length ? null : document.get("k");
  return /^[^\s'"#]/.test(word) && !word.includes("\n") && value !== null && typeof value !== "object" && String(value) === word ? word : JSON.stringify(word);
}

// Returns the one replacement that leads from a text to another.
export function difference(before: string, after: string): Change | null {
  if (before === after) return null;
  let from = 0, tail = 0;
  const most = Math.min(before.length, after.length);
  while (from < most && before[from] === after[from]) from++;
  while (tail < most - from && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail++;
  return { from, to: before.length - tail, insert: after.slice(from, after.length - tail) };
}
