// Studio inside another page (?embed#m=...): the machine moves, and can be dragged; a link leads to all of Studio. Nothing is kept.
import { byId, el } from "./dom";
import { words } from "./words";

export const isEmbedded = new URLSearchParams(location.search).has("embed");

// Sets the page up. Returns what is to be done once the machine is there.
export function embed(play: () => void): () => void {
  document.body.classList.add("embedded");
  byId("stage").append(el("a", { id: "whole", href: `${location.pathname}${location.hash}`, target: "_blank", rel: "noopener" }, words.embed));
  return () => { if (!matchMedia("(prefers-reduced-motion: reduce)").matches) play(); };
}
