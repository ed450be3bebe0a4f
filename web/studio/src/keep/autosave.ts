// Keeps the machine in the browser after every edit, a slot for each tab, so that tabs never write over each other. A new
// tab begins with what was kept last.
import type { Session } from "../session";
import { words } from "../words";

const PREFIX = "yoke-studio-1:", MOST = 8; // slots
export interface Kept { name: string; text: string; tab: string; when: number }

const random = (): string => Array.from(crypto.getRandomValues(new Uint32Array(2)), (part) => part.toString(36)).join("");

export class Autosave {
  private key: string;
  private tab = random(); // a page that was duplicated has the same slot and another name
  private timer = 0;
  private isFull = false;
  isOff = false; // the machine is kept elsewhere: by a server
  onOther: (kept: Kept) => void = () => {};

  constructor(private session: Session) {
    let slot = random();
    try {
      slot = sessionStorage.getItem(PREFIX) ?? slot;
      sessionStorage.setItem(PREFIX, slot);
    } catch { /* no storage: nothing is kept, and keep() says so */ }
    this.key = PREFIX + slot;
    session.on("text", () => { window.clearTimeout(this.timer); this.timer = window.setTimeout(() => this.keep(), 250); });
    addEventListener("pagehide", () => this.keep());
    addEventListener("storage", (event) => {
      const kept = event.key === this.key ? read(event.newValue) : null;
      if (kept && kept.tab !== this.tab && kept.text !== this.session.text && !this.isOff) this.onOther(kept);
    });
  }

  // Returns what this tab kept, or else what was kept last.
  last(): Kept | null {
    try {
      return read(localStorage.getItem(this.key)) ?? slots()[0]?.kept ?? null;
    } catch {
      return null;
    }
  }

  keep(): void {
    window.clearTimeout(this.timer);
    const { name, text } = this.session;
    try {
      if (this.isOff || (text === "" && !localStorage.getItem(this.key)) || read(localStorage.getItem(this.key))?.text === text) return;
      localStorage.setItem(this.key, JSON.stringify({ name, text, tab: this.tab, when: Date.now() } satisfies Kept));
      for (const old of slots().slice(MOST)) if (old.key !== this.key) localStorage.removeItem(old.key);
      this.isFull = false;
    } catch {
      if (!this.isFull) this.session.emit("said", words.say.storageFull);
      this.isFull = true;
    }
  }
}

// Returns all slots, the last first.
function slots(): { key: string; kept: Kept }[] {
  const found: { key: string; kept: Kept }[] = [];
  for (let k = 0; k < localStorage.length; k++) {
    const key = localStorage.key(k)!, kept = key.startsWith(PREFIX) ? read(localStorage.getItem(key)) : null;
    if (kept) found.push({ key, kept });
  }
  return found.sort((a, b) => b.kept.when - a.kept.when);
}

function read(text: string | null): Kept | null {
  try {
    const kept = JSON.parse(text ?? "null") as Partial<Kept> | null;
    return kept && typeof kept.text === "string" && typeof kept.name === "string" ? { name: kept.name, text: kept.text, tab: String(kept.tab), when: Number(kept.when) || 0 } : null;
  } catch {
    return null;
  }
}
