// Studio: starts the core, the editor, the canvas and the panels, and joins them.
import "./styles/studio.css";
import "uplot/dist/uPlot.min.css";
import { startCore } from "../../core/client";
import type { WorkerLike } from "../../core/client";
import { Canvas } from "./canvas/canvas";
import { Keys } from "./canvas/keys";
import { Hand } from "./canvas/pointer";
import { TOOLS } from "./canvas/tools";
import { byId, el, fill, isTyping } from "./dom";
import { embed, isEmbedded } from "./embed";
import { Editor } from "./editor/editor";
import { icon } from "./icons";
import { inline } from "./inline";
import { unpack } from "./keep/address";
import { Autosave } from "./keep/autosave";
import { Files } from "./keep/files";
import { Server } from "./keep/server";
import { Motion } from "./motion";
import { Command } from "./panels/command";
import { Diagrams } from "./panels/diagrams";
import { Design } from "./panels/design";
import { card, loadExamples, share, showExports, showGallery, showHelp } from "./panels/dialogs";
import { Equations } from "./panels/equations";
import { Lacks } from "./panels/lacks";
import { Parts } from "./panels/parts";
import { Status } from "./panels/status";
import { Tabs } from "./panels/tabs";
import { Session } from "./session";
import { words } from "./words";

const FEATURED = ["four-bar", "quick-return", "jansen", "gas-engine", "double-pendulum", "epicyclic"];

const sources = {
  worker: () => new Worker(inline?.worker ?? "worker.js") as unknown as WorkerLike, small: inline?.small ?? "core.wasm", panels: inline?.whole ?? "panels.wasm", whole: inline?.whole ?? "yoke.wasm",
  report: inline?.report ?? "report.js",
};
const session: Session = new Session(startCore({
  ...sources,
  onRestart: () => session.emit("lost", words.coreLost),
}));
const editor = new Editor(byId("panel-text"), session);
const canvas = new Canvas(document.querySelector<SVGSVGElement>("#canvas")!, session);
const hand = new Hand(canvas, session);
new Keys(canvas, hand, session);
const motion = new Motion(session, canvas, hand);
const parts = new Parts(session, editor);
const diagrams = new Diagrams(session, motion);
const equations = new Equations(session);
const design = new Design(session, canvas, () => startCore(sources));
new Command(session);
new Lacks(session);
const status = new Status(session, editor);
const autosave = new Autosave(session);
const tabs = new Tabs((id) => { diagrams.visible = id === "diagrams"; equations.visible = id === "equations"; });
const files = new Files(session, load);
const nameField = byId<HTMLInputElement>("name");
let server: Server | null = null;

function load(text: string, name: string): void {
  motion.begin();
  session.name = name || words.untitled;
  nameField.value = session.name;
  session.selection = null;
  session.want(null);
  session.stand = { kind: "start" };
  [session.machine, session.scene, session.start, session.pose] = [null, null, null, null];
  files.forget();
  canvas.begin();
  editor.load(text);
  void session.settled.then(() => canvas.fit());
}

function button(id: string, word: string, action: () => void, name?: string): HTMLButtonElement {
  return el("button", { id, title: word, "aria-label": name ? word : undefined, class: name ? "icon-button" : "text", onclick: action }, name ? icon(name) : word);
}

function build(): void {
  try {
    const theme = localStorage.getItem("yoke-studio-theme");
    if (theme) document.documentElement.dataset.theme = theme;
  } catch { /* the system's theme holds */ }
  document.title = words.title;
  const { menu } = words;
  fill(byId("menu"), button("new", menu.new, () => load("", words.untitled)), button("examples", menu.examples, () => void showGallery(load)), button("open", menu.open, () => void files.open()),
    button("save", menu.save, () => void save()), button("share", menu.share, () => void share(session)), button("export", menu.export, () => showExports(session, { start: () => startCore(sources), period: motion.period, lasts: motion.lasts, traces: canvas.overlay.traced })));
  fill(byId("right-menu"), button("undo", `${menu.undo} (Ctrl+Z)`, editor.undo, "undo"), button("redo", `${menu.redo} (Ctrl+Y)`, editor.redo, "redo"), button("theme", menu.theme, turnTheme, "theme"), button("help", menu.help, showHelp, "help"));
  fill(byId("tools"), ...TOOLS.map((tool) => {
    const [name, how] = words.tools[tool.id];
    return el("button", { id: `tool-${tool.id}`, "aria-pressed": String(tool.id === "select"), title: `${name} (${tool.key.toUpperCase()}). ${how}`, onclick: () => hand.choose(tool.id) }, icon(tool.id), el("span", {}, name), el("kbd", { "aria-hidden": "true" }, tool.key.toUpperCase()));
  }));
  fill(byId("zoom"), button("fit", `${words.canvas.fit} (0)`, () => canvas.fit(), "fit"), button("zoom-in", words.canvas.zoomIn, () => zoom(1.3), "in"), button("zoom-out", words.canvas.zoomOut, () => zoom(1 / 1.3), "out"));
  hand.onTool = (tool) => {
    for (const one of TOOLS) byId(`tool-${one.id}`).setAttribute("aria-pressed", String(one === tool));
    canvas.root.dataset.tool = tool.id;
    invite();
    if (tool.id === "curve" || tool.id === "pose") tabs.show("design");
    session.emit("said", words.tools[tool.id][1]);
  };
  design.onPlace = () => hand.choose("pose");
  design.onDraw = () => hand.choose("curve");
  design.onTake = () => {
    hand.choose("select");
    motion.keep("coupler", "P");
  };
  nameField.addEventListener("change", () => { session.name = nameField.value.trim() || words.untitled; nameField.value = session.name; });
}

const zoom = (factor: number): void => {
  canvas.view.zoom(factor, [canvas.view.width / 2, canvas.view.height / 2]);
  canvas.onView();
  canvas.redraw();
};

async function save(): Promise<void> {
  if (!server) return files.save();
  if (await server.save()) session.emit("said", words.say.saved(session.name));
}

function turnTheme(): void {
  const isDark = document.documentElement.dataset.theme ? document.documentElement.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  document.documentElement.dataset.theme = isDark ? "light" : "dark";
  try { localStorage.setItem("yoke-studio-theme", document.documentElement.dataset.theme); } catch { /* it holds for this visit */ }
  diagrams.refresh();
  canvas.recolour();
}

function listen(): void {
  addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      const action = { s: () => void save(), o: () => void files.open(), z: event.shiftKey ? editor.redo : editor.undo, y: editor.redo }[key];
      if (!action || ((key === "z" || key === "y") && isTyping(event))) return;
      event.preventDefault();
      action();
      return;
    }
    if (isTyping(event) || event.altKey || event.defaultPrevented) return;
    const isButton = (event.target as HTMLElement).closest("button, input, summary, [role=tab]") !== null;
    const tool = TOOLS.find((one) => one.key === key);
    if (tool) hand.choose(tool.id);
    else if (key === " " && !isButton) motion.toggle();
    else if (key === "escape") { if (!hand.cancel()) { if (hand.tool.id !== "select") hand.choose("select"); else session.select(null); } }
    else if (key === "[") motion.step(-1);
    else if (key === "]") motion.step(1);
    else if (key === "home" && !isButton) void motion.restart();
    else if (key === "0") canvas.fit();
    else if (key === "+" || key === "=") zoom(1.2);
    else if (key === "-") zoom(1 / 1.2);
    else if (key === "t") void motion.trace();
    else if (key === "a") canvas.arrows.turn();
    else if (key === "o") void motion.toggleGhosts();
    else if (key === "delete" || key === "backspace") void parts.remove();
    else return;
    event.preventDefault();
  });
  session.on("opened", () => {
    invite();
    byId("undo").toggleAttribute("disabled", !editor.canUndo);
    byId("redo").toggleAttribute("disabled", !editor.canRedo);
  });
  addEventListener("hashchange", () => void fromAddress());
  autosave.onOther = (kept) => status.ask(words.say.otherTab, [[words.keep.takeTheirs, () => editor.replace(kept.text)], [words.keep.keepMine, () => autosave.keep()]]);
}

// An empty canvas invites.
let isInviting = false;
function invite(): void {
  const isEmpty = session.text.trim() === "" && hand.tool.id === "select", box = byId("invite");
  box.hidden = !isEmpty;
  if (!isEmpty || isInviting) return;
  isInviting = true;
  const cards = el("div", { class: "cards" });
  fill(box, el("h2", {}, words.canvas.invite), el("p", {}, words.canvas.inviteHow), el("div", { class: "row" }, el("button", { class: "strong", onclick: () => { hand.choose("bar"); canvas.root.focus(); } }, words.canvas.drawBar),
    el("button", { class: "text", onclick: () => void showGallery(load) }, words.menu.examples), el("button", { class: "text", onclick: () => void files.open() }, words.menu.open)), cards);
  void loadExamples().then((all) => fill(cards, ...FEATURED.map((id) => all.find((one) => one.id === id)).filter((one) => one !== undefined).map((one) => card(one, () => load(one.text, one.id)))));
}

async function fromAddress(): Promise<boolean> {
  const found = await unpack(location.hash);
  if (found === undefined) session.emit("said", words.say.linkBroken);
  if (!found) return false;
  history.replaceState(null, "", location.pathname + location.search); // the machine is the page's now, and edits do not change a link
  load(found.text, found.name);
  return true;
}

async function fromServer(): Promise<boolean> {
  const found = await Server.find(session);
  if (!found) return false;
  server = found.server;
  autosave.isOff = true;
  load(found.file.text, found.file.name.replace(/\.ya?ml$/, ""));
  server.onChange = (text) => editor.replace(text);
  server.onConflict = () => status.ask(words.say.conflict, [[words.keep.reload, () => void server!.reload()], [words.keep.overwrite, () => void server!.save(true)]]);
  return true;
}

function fromPage(): boolean {
  if (inline?.machine) load(inline.machine.text, inline.machine.name.replace(/\.ya?ml$/, ""));
  return Boolean(inline?.machine);
}

// Until the machine is there nothing can be typed or drawn, which it would replace.
async function begin(): Promise<void> {
  document.body.inert = true;
  build();
  listen();
  tabs.show("text");
  if (typeof WebAssembly === "undefined") status.ask(words.coreFails, []);
  const ready = isEmbedded ? embed(() => motion.toggle()) : null;
  autosave.isOff = isEmbedded;
  if (ready) {
    if (await fromAddress()) await session.settled.then(ready);
    return;
  }
  if ((await fromAddress()) || (await fromServer()) || fromPage()) return;
  const kept = autosave.last();
  if (kept) load(kept.text, kept.name);
  else load("", words.untitled);
}
void begin().finally(() => { document.body.inert = false; });
if ("serviceWorker" in navigator && isSecureContext && location.protocol !== "file:" && !isEmbedded && !new URLSearchParams(location.search).has("token")) void navigator.serviceWorker.register("sw.js").catch(() => undefined);
