// The linkages found, as cards in the order of their merit: those of earlier searches, and behind them those of the present one.

export interface Candidate { model: string; mechanism: string; type?: string; worst: number; transmission?: [number, number]; lengths?: Record<string, number> }
interface Place { key: string; card: HTMLElement | null } // no card: an earlier search has found it

// Other starts find the same linkage again, but for its last digits.
const keyOf = (one: Candidate): string => (one.lengths ? [one.mechanism, ...Object.values(one.lengths).map((value) => value.toPrecision(3))].join(" ") : one.model);

// Returns what takes pieces of a text and calls back with each whole line that is an object of JSON.
export function readLines(tell: (line: string) => void): (text: string) => void {
  let rest = "";
  return (text) => {
    const lines = (rest + text).split("\n");
    rest = lines.pop()!;
    for (const line of lines) if (/^\{.+\}$/.test(line)) tell(line);
  };
}

export class Finds {
  private earlier = new Set<string>();
  private now: Place[] = [];

  constructor(private box: HTMLElement, private make: (one: Candidate) => HTMLElement) {}

  get count(): number { return this.now.filter(({ card }) => card).length; } // new in this search
  get isEmpty(): boolean { return this.box.childElementCount === 0; }

  clear(): void {
    this.earlier.clear();
    this.now = [];
    this.box.replaceChildren();
  }

  // Begins another search.
  begin(): void {
    for (const { key } of this.now.splice(0)) this.earlier.add(key);
  }

  // Puts a linkage into its place among those of this search, whose number is limited.
  put(one: Candidate, at: number, most: number): void {
    const key = keyOf(one), isKnown = this.earlier.has(key) || this.now.some((other) => other.key === key), card = isKnown ? null : this.make(one);
    const behind = this.now.slice(at).find((other) => other.card)?.card ?? null;
    this.now.splice(at, 0, { key, card });
    if (card) this.box.insertBefore(card, behind);
    for (const { card: last } of this.now.splice(most)) last?.remove();
  }

  // Takes the final answer of the search in place of its earlier lines. Returns how many are new.
  settle(candidates: Candidate[]): number {
    const told = new Map(this.now.filter(({ card }) => card).map(({ key, card }) => [key, card]));
    this.now.forEach(({ card }) => card?.remove());
    this.now = [];
    for (const one of candidates) {
      const key = keyOf(one), isKnown = this.earlier.has(key) || this.now.some((other) => other.key === key), card = isKnown ? null : (told.get(key) ?? this.make(one));
      this.now.push({ key, card });
      if (card) this.box.append(card);
    }
    return this.count;
  }
}
