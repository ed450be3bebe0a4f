// The dialogs: gallery of examples, export, share, help.
import type { Core } from "../../../core/door";
import { el, fill } from "../dom";
import { inline } from "../inline";
import { picture } from "../markup";
import { download } from "../keep/files";
import type { Films } from "../keep/film";
import { later } from "../later";
import { pngOf } from "../keep/png";
import { isTooLong, pack } from "../keep/address";
import type { Session } from "../session";
import { words } from "../words";

const FILE = "machine.yaml";
export interface Example { id: string; name: string; about: string; text: string; picture: string }

let examples: Promise<Example[]> | null = null;
// Loads the examples once; a page without them (opened from disk) has none.
export function loadExamples(): Promise<Example[]> {
  const kept = inline?.files["gallery.json"];
  examples ??= kept ? Promise.resolve(JSON.parse(kept) as Example[]) : fetch("gallery.json").then((reply) => (reply.ok ? reply.json() : [])).catch(() => { examples = null; return []; });
  return examples;
}

function open(title: string, ...content: (Node | string | null)[]): HTMLDialogElement {
  const dialog = el("dialog", { "aria-label": title, closedby: "any" }, el("header", {}, el("h2", {}, title), el("button", { class: "quiet", "aria-label": words.menu.close, onclick: () => dialog.close() }, "✕")), ...content);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("click", (event) => { if (event.target === dialog) dialog.close(); });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

export function card(example: Example, choose: () => void): HTMLElement {
  const drawing = picture(example.picture);
  drawing?.querySelectorAll(":scope > rect, :scope > title").forEach((one) => one.remove());
  drawing?.setAttribute("aria-hidden", "true");
  return el("button", { class: "card", onclick: choose, "data-example": example.id }, el("span", { class: "card-picture" }, drawing), el("b", {}, example.name), el("span", { class: "about" }, example.about));
}

export async function showGallery(load: (text: string, name: string) => void): Promise<void> {
  const search = el("input", { type: "search", placeholder: words.gallery.search, "aria-label": words.gallery.search }), list = el("div", { class: "cards" });
  const dialog = open(words.gallery.title, search, list);
  dialog.classList.add("wide");
  const all = await loadExamples();
  if (!all.length) return fill(list, el("p", {}, words.say.noPictures));
  const cards = all.map((one) => ({ element: card(one, () => { dialog.close(); load(one.text, one.id); }), words: `${one.id} ${one.name} ${one.about}`.toLowerCase() }));
  fill(list, ...cards.map((one) => one.element));
  search.addEventListener("input", () => {
    for (const one of cards) one.element.hidden = !one.words.includes(search.value.trim().toLowerCase());
  });
}

export async function share(session: Session): Promise<void> {
  const hash = await pack(session.name, session.text), address = `${location.origin === "null" ? location.href.split("#")[0] : location.origin + location.pathname}${hash}`;
  if (isTooLong(hash)) return session.emit("said", words.say.linkTooLong(String(Math.ceil(hash.length / 1024))));
  const link = el("input", { type: "text", readonly: true, value: address, "aria-label": words.menu.share, class: "link", onfocus: () => link.select() });
  const note = el("p", { class: "hint", role: "status" }, words.say.linkShown);
  open(words.menu.share, note, link);
  link.select();
  try {
    await navigator.clipboard.writeText(address);
    note.textContent = words.say.copied;
  } catch { /* the link is there to be copied by hand */ }
}

// Each export is the command's own answer: its words, and the name of the file it writes or prints.
const EXPORTS: [string, string[], string][] = [
  ["report", ["report", FILE, "-o", "report.html"], "report.html"], ["svg", ["draw", FILE, "-o", "drawing.svg"], "drawing.svg"],
  ["movie", ["draw", FILE, "--animate", "moving.svg"], "moving.svg"], ["csv", ["sweep", FILE, "--over", "t=0:PERIODs", "--steps", "180", "--format", "csv"], "table.csv"],
  ["c", ["code", FILE], "machine.c"], ["latex", ["derive", FILE, "--format", "latex"], "equations.tex"], ["page", ["derive", FILE, "--format", "mathml"], "equations.html"],
];

const films = later<Films>("film.js", "yokeFilm", words.exports.noFilms as string);
const FILMS: [string, string][] = [["webm", "video/webm;codecs=vp9"], ["webm", "video/webm"], ["mp4", "video/mp4;codecs=avc1.42E01F"], ["mp4", "video/mp4"]];
// Returns the kind of film that the browser records under a name; null if it cannot.
const recorded = (kind: string): string | null =>
  typeof MediaRecorder === "undefined" ? null : FILMS.find(([name, type]) => name === kind && MediaRecorder.isTypeSupported(type))?.[1] ?? null;

// What a film needs: a core of its own, a turn of the machine and how long it lasts on the screen, s, and the paths on the canvas.
export interface Filming { start: () => Core & { close(): void }; period: number; lasts: number; traces: Float64Array[] }

export function showExports(session: Session, { start, period, lasts, traces }: Filming): void {
  const note = el("pre", { class: "hint", role: "status" });
  const line = (id: string, action: () => void) => {
    const [name, about] = words.exports[id] as string[];
    return el("button", { class: "part", "data-export": id, onclick: action }, el("b", {}, name), el("span", {}, about));
  };
  const ask = async (list: string[], file: string): Promise<Uint8Array | string | null> => {
    note.textContent = words.command.wait;
    const reply = await session.ask(() => session.core.run(list.map((word) => word.replace("PERIOD", String(period))), { [FILE]: session.text }));
    if (!reply) return null;
    note.textContent = reply.err.trim();
    const made = reply.files[file] ?? (reply.exit === 0 && reply.out ? reply.out : null);
    if (made === null && !note.textContent) note.textContent = words.say.noAnswer;
    return made;
  };
  const run = async (list: string[], file: string) => {
    const made = await ask(list, file);
    if (made !== null) download(`${session.name}-${file}`, made);
  };
  // A picture of points is the browser's work; where it fails, its own words say why.
  const png = async () => {
    try {
      const drawn = await ask(["draw", FILE, "-o", "drawing.svg"], "drawing.svg");
      if (drawn instanceof Uint8Array) download(`${session.name}-drawing.png`, await pngOf(new TextDecoder().decode(drawn)));
    } catch (error) {
      note.textContent = String((error as Error).message ?? error);
    }
  };
  const part = el("progress", { max: "1", value: "0", hidden: true, "aria-label": words.exports.shooting as string });
  const shoot = async (kind: string) => {
    const core = start(), order = { text: session.text, name: session.name, seconds: period, lasts, traces, tell: (done: number) => { part.value = done; } };
    [part.hidden, note.textContent] = [false, words.exports.shooting as string];
    try {
      const { film, gif } = await films();
      download(`${session.name}.${kind}`, kind === "gif" ? await gif(core, order) : await film(core, order, recorded(kind)!));
      note.textContent = "";
    } catch (error) {
      note.textContent = String((error as Error).message ?? error);
    } finally {
      part.hidden = true;
      core.close();
    }
  };
  open(words.exports.title as string, el("div", { class: "exports" }, line("yaml", () => download(`${session.name}.yaml`, session.text)), ...EXPORTS.map(([id, list, file]) => line(id, () => void run(list, file))),
    line("png", () => void png()), line("gif", () => void shoot("gif")), ...["webm", "mp4"].filter(recorded).map((kind) => line(kind, () => void shoot(kind)))),
    el("p", { class: "hint" }, words.exports.others as string), part, note);
}

export function showHelp(): void {
  open(words.help.title, el("dl", { class: "keys" }, ...words.help.keys.flatMap(([key, what]) => [el("dt", {}, key), el("dd", {}, what)])));
}
