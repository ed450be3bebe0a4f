// The tabs of the panel beside the canvas, and its width.
import { byId, el, fill } from "../dom";
import { words } from "../words";

const NARROW = "(max-width: 820px)"; // as in narrow.css
const IDS = ["text", "parts", "diagrams", "equations", "design", "command"] as const;
type Id = (typeof IDS)[number];

export class Tabs {
  constructor(private changed: (id: Id) => void) {
    fill(byId("tabs"), ...IDS.map((id) => el("button", { id: `tab-${id}`, role: "tab", "aria-controls": `panel-${id}`, onclick: () => this.press(id) }, words.tabs[id])));
    byId("tabs").addEventListener("keydown", (event) => {
      const now = IDS.findIndex((id) => byId(`tab-${id}`) === event.target), way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (way === undefined || now < 0) return;
      const next = IDS[(now + way + IDS.length) % IDS.length];
      this.show(next);
      byId(`tab-${next}`).focus();
      event.preventDefault();
    });
    this.widen(byId("divider"));
    matchMedia(NARROW).addEventListener("change", () => this.dress());
  }

  // On a phone the tab of the panel that is open folds it away, so that the drawing has the window.
  private press(id: Id): void {
    const isFolding = matchMedia(NARROW).matches && !this.isFolded && byId(`tab-${id}`).getAttribute("aria-selected") === "true";
    this.show(id);
    this.fold(isFolding);
  }

  private get isFolded(): boolean {
    return byId("panel").classList.contains("folded");
  }

  private fold(isFolded: boolean): void {
    byId("panel").classList.toggle("folded", isFolded);
    this.dress();
  }

  // A screen reader hears whether the panel is folded where it can be.
  private dress(): void {
    const canFold = matchMedia(NARROW).matches;
    for (const id of IDS) {
      const tab = byId(`tab-${id}`);
      if (canFold && tab.getAttribute("aria-selected") === "true") tab.setAttribute("aria-expanded", String(!this.isFolded));
      else tab.removeAttribute("aria-expanded");
    }
  }

  show(shown: Id): void {
    for (const id of IDS) {
      const tab = byId(`tab-${id}`), isShown = id === shown;
      tab.setAttribute("aria-selected", String(isShown));
      tab.tabIndex = isShown ? 0 : -1;
      byId(`panel-${id}`).hidden = !isShown;
    }
    this.fold(false);
    this.changed(shown);
  }

  // The divider is dragged, or moved by the arrow keys.
  private widen(divider: HTMLElement): void {
    const set = (width: number) => {
      const most = Math.max(320, innerWidth - 420), now = Math.min(most, Math.max(280, width));
      document.documentElement.style.setProperty("--panel", `${now}px`);
      divider.setAttribute("aria-valuenow", String(Math.round((100 * now) / innerWidth)));
    };
    divider.addEventListener("pointerdown", (event) => { divider.setPointerCapture(event.pointerId); event.preventDefault(); });
    divider.addEventListener("pointermove", (event) => { if (divider.hasPointerCapture(event.pointerId)) set(innerWidth - event.clientX); });
    divider.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: 24, ArrowRight: -24 }[event.key];
      if (way) set(byId("panel").getBoundingClientRect().width + way);
    });
  }
}
