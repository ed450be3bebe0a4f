// Files of the person: opened, dropped, saved - into the same file again where the browser allows it.
import { byId } from "../dom";
import type { Session } from "../session";
import { words } from "../words";

const LARGEST = 4 << 20; // bytes; no machine file is larger
interface Handle { name: string; getFile(): Promise<File>; createWritable(): Promise<{ write(text: string): Promise<void>; close(): Promise<void> }> }
interface Picker {
  showOpenFilePicker?(options: unknown): Promise<Handle[]>;
  showSaveFilePicker?(options: unknown): Promise<Handle>;
}
const TYPES = [{ description: "Yoke machine", accept: { "text/yaml": [".yaml", ".yml"] } }];

export function download(name: string, content: string | Uint8Array): void {
  const type = name.endsWith(".svg") ? "image/svg+xml" : name.endsWith(".html") ? "text/html" : name.endsWith(".png") ? "image/png" : "text/plain";
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type })), link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export class Files {
  private handle: Handle | null = null;

  constructor(private session: Session, private load: (text: string, name: string) => void) {
    const input = byId<HTMLInputElement>("file");
    input.addEventListener("change", () => { if (input.files?.[0]) void this.read(input.files[0], null); input.value = ""; });
    addEventListener("dragover", (event) => { if (event.dataTransfer?.types.includes("Files")) { event.preventDefault(); document.body.classList.add("dropping"); } });
    addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
    addEventListener("drop", (event) => {
      document.body.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (!file) return;
      event.preventDefault();
      void this.read(file, null);
    });
  }

  forget(): void {
    this.handle = null;
  }

  async open(): Promise<void> {
    const picker = window as unknown as Picker;
    if (!picker.showOpenFilePicker) return byId("file").click();
    const [handle] = await picker.showOpenFilePicker({ types: TYPES }).catch(() => []);
    if (handle) await this.read(await handle.getFile(), handle);
  }

  private async read(file: File, handle: Handle | null): Promise<void> {
    if (file.size > LARGEST) return this.session.emit("said", words.say.fileTooLarge);
    this.load(await file.text(), file.name.replace(/\.ya?ml$/, ""));
    this.handle = handle;
  }

  async save(): Promise<void> {
    const { session } = this, picker = window as unknown as Picker, name = `${session.name}.yaml`;
    try {
      if (!this.handle && picker.showSaveFilePicker) this.handle = await picker.showSaveFilePicker({ suggestedName: name, types: TYPES });
      if (this.handle) {
        const writer = await this.handle.createWritable();
        await writer.write(session.text);
        await writer.close();
      } else download(name, session.text);
      session.emit("said", words.say.saved(this.handle?.name ?? name));
    } catch (error) {
      if ((error as Error).name !== "AbortError") session.emit("said", String((error as Error).message));
    }
  }
}
