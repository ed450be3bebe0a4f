// Writes pictures one after the other as a GIF that moves by itself (GIF89a, with the lossless compression of Welch, 1984).
const COLOURS = 256, BITS = 8;

export interface Picture { width: number; height: number; data: Uint8ClampedArray } // red, green, blue, opacity of each pixel

// Colours in steps of eight, as one number.
const stepOf = (data: Uint8ClampedArray, at: number): number => ((data[at] >> 3) << 10) | ((data[at + 1] >> 3) << 5) | (data[at + 2] >> 3);

// The colours that most pixels have: their mean in each step.
class Palette {
  readonly colours: number[][];
  private known = new Map<number, number>();

  constructor(pictures: Picture[]) {
    const found = new Map<number, number[]>(); // count, sums
    for (const { data } of pictures) for (let at = 0; at < data.length; at += 4) {
      const step = stepOf(data, at), sums = found.get(step);
      if (!sums) found.set(step, [1, data[at], data[at + 1], data[at + 2]]);
      else { sums[0]++; sums[1] += data[at]; sums[2] += data[at + 1]; sums[3] += data[at + 2]; }
    }
    this.colours = Array.from(found.values()).sort((a, b) => b[0] - a[0]).slice(0, COLOURS).map(([count, ...sums]) => sums.map((sum) => Math.round(sum / count)));
  }

  indexOf(data: Uint8ClampedArray, at: number): number {
    const step = stepOf(data, at), known = this.known.get(step);
    if (known !== undefined) return known;
    let best = 0, least = Infinity;
    this.colours.forEach(([r, g, b], k) => {
      const far = (r - data[at]) ** 2 + (g - data[at + 1]) ** 2 + (b - data[at + 2]) ** 2;
      if (far < least) [best, least] = [k, far];
    });
    this.known.set(step, best);
    return best;
  }
}

class Bytes {
  private list: number[] = [];
  put(...bytes: number[]): void { for (const byte of bytes) this.list.push(byte & 255); }
  word(value: number): void { this.put(value, value >> 8); }
  text(value: string): void { for (const letter of value) this.put(letter.charCodeAt(0)); }
  // Blocks of at most 255 bytes, each behind its length.
  blocks(bytes: number[]): void {
    for (let k = 0; k < bytes.length; k += 255) {
      const block = bytes.slice(k, k + 255);
      this.put(block.length, ...block);
    }
    this.put(0);
  }
  get all(): Uint8Array<ArrayBuffer> { return Uint8Array.from(this.list); }
}

// Compresses the indices of a picture: strings seen before become codes, of 9 to 12 bits, the low bit first.
function compress(indices: Uint8Array): number[] {
  const out: number[] = [], clear = 1 << BITS;
  let table = new Map<number, number>(), next = clear + 2, size = BITS + 1, kept = 0, bits = 0;
  const put = (code: number) => {
    kept |= code << bits;
    for (bits += size; bits >= 8; bits -= 8, kept >>= 8) out.push(kept & 255);
  };
  put(clear);
  let code = indices[0];
  for (let k = 1; k < indices.length; k++) {
    const key = (code << BITS) | indices[k], longer = table.get(key);
    if (longer !== undefined) {
      code = longer;
      continue;
    }
    put(code);
    code = indices[k];
    if (next < 4096) {
      table.set(key, next);
      if (next === 1 << size) size++;
      next++;
    } else {
      put(clear);
      [table, next, size] = [new Map(), clear + 2, BITS + 1];
    }
  }
  put(code);
  put(clear + 1);
  if (bits > 0) out.push(kept & 255);
  return out;
}

// Returns a GIF of pictures of one size, each shown for `hundredths` / 100 s, over and over.
export function gifOf(pictures: Picture[], hundredths: number): Uint8Array<ArrayBuffer> {
  const [{ width, height }] = pictures, bytes = new Bytes(), palette = new Palette(pictures.filter((_, k) => k % Math.ceil(pictures.length / 4) === 0));
  bytes.text("GIF89a");
  bytes.word(width);
  bytes.word(height);
  bytes.put(0xf0 | (BITS - 1), 0, 0);
  for (let k = 0; k < COLOURS; k++) bytes.put(...(palette.colours[k] ?? [0, 0, 0]));
  bytes.put(0x21, 0xff, 11);
  bytes.text("NETSCAPE2.0");
  bytes.put(3, 1, 0, 0, 0);
  const indices = new Uint8Array(width * height);
  for (const { data } of pictures) {
    for (let k = 0; k < indices.length; k++) indices[k] = palette.indexOf(data, 4 * k);
    bytes.put(0x21, 0xf9, 4, 0);
    bytes.word(hundredths);
    bytes.put(0, 0, 0x2c, 0, 0, 0, 0);
    bytes.word(width);
    bytes.word(height);
    bytes.put(0, BITS);
    bytes.blocks(compress(indices));
  }
  bytes.put(0x3b);
  return bytes.all;
}
