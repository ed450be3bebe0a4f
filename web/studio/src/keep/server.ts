// The server of `yoke studio FILE`: the file it serves is read here and saved there.
import type { Session } from "../session";
import { words } from "../words";

interface Served { name: string; text: string; version: string }
const EVERY = 2000; // ms between looks at the file

export class Server {
  private version = "";
  private saved = "";
  private address: string;
  private timer = 0;
  onConflict: (text: string) => void = () => {};
  onChange: (text: string) => void = () => {};

  private constructor(private session: Session, token: string) {
    this.address = `machine?token=${encodeURIComponent(token)}`;
  }

  // Returns the server that gave the page, with its file; null if the page came from elsewhere.
  static async find(session: Session): Promise<{ server: Server; file: Served } | null> {
    const token = new URLSearchParams(location.search).get("token");
    if (!token || !location.protocol.startsWith("http")) return null;
    const server = new Server(session, token), file = await server.get();
    if (!file) return null;
    server.begin(file);
    return { server, file };
  }

  private async get(): Promise<Served | null> {
    try {
      const reply = await fetch(this.address, { cache: "no-store" });
      return reply.ok ? ((await reply.json()) as Served) : null;
    } catch {
      return null;
    }
  }

  private begin(file: Served): void {
    [this.version, this.saved] = [file.version, file.text];
    this.session.on("text", () => { window.clearTimeout(this.timer); this.timer = window.setTimeout(() => void this.save(), 800); });
    window.setInterval(() => void this.look(), EVERY);
  }

  // Looks whether another program changed the file.
  private async look(): Promise<void> {
    if (document.hidden) return;
    const file = await this.get();
    if (!file || file.version === this.version) return;
    if (this.session.text === this.saved) {
      [this.version, this.saved] = [file.version, file.text];
      this.onChange(file.text);
    } else this.onConflict(file.text);
  }

  // Saves the text; `isForced` writes over what another program wrote.
  async save(isForced = false): Promise<boolean> {
    const { text } = this.session;
    if (text === this.saved && !isForced) return true;
    if (isForced) this.version = (await this.get())?.version ?? this.version;
    try {
      const reply = await fetch(this.address, { method: "PUT", body: text, headers: { "If-Match": this.version, "Content-Type": "text/yaml" } });
      if (reply.status === 409) {
        const file = await this.get();
        if (file) this.onConflict(file.text);
        return false;
      }
      if (!reply.ok) throw new Error(String(reply.status));
      const answer = (await reply.json().catch(() => null)) as { version?: string } | null;
      this.version = answer?.version ?? reply.headers.get("ETag") ?? (await this.get())?.version ?? this.version;
      this.saved = text;
      return true;
    } catch {
      this.session.emit("said", words.say.offline);
      return false;
    }
  }

  // Takes the file's text in place of the editor's.
  async reload(): Promise<void> {
    const file = await this.get();
    if (!file) return;
    [this.version, this.saved] = [file.version, file.text];
    this.onChange(file.text);
  }
}
