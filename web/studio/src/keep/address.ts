// The machine in the address: #m=1. + base64url of the deflated text. Treat it as a stranger's.
const VERSION = "1.";
const LONGEST = 64 << 10; // characters of a link
const LARGEST = 4 << 20; // bytes of the text in it

async function through(bytes: Uint8Array, stream: { readable: ReadableStream; writable: WritableStream }, most: number): Promise<Uint8Array> {
  const reader = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array>).getReader(), parts: Uint8Array[] = [];
  for (let size = 0; ;) {
    const { done, value } = await reader.read();
    if (done) return new Uint8Array(await new Blob(parts as BlobPart[]).arrayBuffer());
    size += value.length;
    if (size > most) {
      await reader.cancel();
      throw new RangeError("too large");
    }
    parts.push(value);
  }
}

export async function pack(name: string, text: string): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify([name, text])), new CompressionStream("deflate-raw"), Infinity);
  let binary = "";
  for (let k = 0; k < bytes.length; k += 4096) binary += String.fromCharCode(...bytes.subarray(k, k + 4096));
  return `#m=${VERSION}${btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
}

export const isTooLong = (hash: string): boolean => hash.length > LONGEST;

// Returns the machine of an address; null if there is none, undefined if it cannot be read.
export async function unpack(hash: string): Promise<{ name: string; text: string } | null | undefined> {
  if (!hash.startsWith("#m=")) return null;
  if (!hash.startsWith(`#m=${VERSION}`) || hash.length > 2 * LONGEST) return undefined;
  try {
    const binary = atob(hash.slice(3 + VERSION.length).replace(/-/g, "+").replace(/_/g, "/")), bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const list: unknown = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw"), LARGEST)));
    const [name, text] = Array.isArray(list) ? list : [];
    return typeof name === "string" && typeof text === "string" ? { name: name.slice(0, 80), text } : undefined;
  } catch {
    return undefined;
  }
}
