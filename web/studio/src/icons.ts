// The icons: lines of one weight on a square of 20.
import { svg } from "./dom";

const PATHS: Record<string, string> = {
  select: "M5 3l10 7-4.6.9L8 15.5z",
  bar: "M6.2 13.8l7.6-7.6M4.5 17.5a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM15.5 6.5a2 2 0 1 0 0-4 2 2 0 0 0 0 4z",
  polygon: "M4 14.5L6.5 4l10 4.5-4 8z",
  slot: "M3.5 13.5L13 4a2.5 2.5 0 0 1 3.5 3.5L7 17a2.5 2.5 0 0 1-3.5-3.5zM10 12a2 2 0 1 0 0-4 2 2 0 0 0 0 4z",
  rack: "M2 16.5h16M2 16.5V13h2.5v3h2.5v-3h2.5v3h2.5v-3h2.5v3h2.5v-3M10 10.5a4 4 0 1 0 0-8 4 4 0 0 0 0 8zM10 6.5h.1",
  belt: "M5.5 4.2l9 2.6M5.5 15.8l9-2.6M6 16a6 6 0 1 1 0-12M14 6.8a3.3 3.3 0 1 1 0 6.4M6 10h.1M14 10h.1",
  cam: "M7 18c-3 0-5-2.2-5-5 0-2.6 1.6-4.4 3.5-5L12 5c2 .5 2.2 2 1 4l-1.5 5c-.6 2.4-2 4-4.5 4zM7 13h.1M15 5.5a2 2 0 1 0 0-4 2 2 0 0 0 0 4z",
  damper: "M2 10h5M7 5.5v9h7M7 5.5h7M11 7.5v5M11 10h7",
  point: "M10 12.5a2.5 2.5 0 1 0 0-5 2.5 2.5 0 0 0 0 5zM10 2.5v3M10 14.5v3M2.5 10h3M14.5 10h3",
  pin: "M10 12.5a2.5 2.5 0 1 0 0-5 2.5 2.5 0 0 0 0 5zM3 17l5.2-5.2M17 17l-5.2-5.2",
  ground: "M10 7a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM9 7l-4 6.5h10L11 7M3 13.5h14M5 13.5l-2 3M9 13.5l-2 3M13 13.5l-2 3M17 13.5l-2 3",
  slide: "M5.5 6.5h9v5h-9zM2 11.5h16M4 11.5l-2 3M8.5 11.5l-2 3M13 11.5l-2 3M17.5 11.5l-2 3",
  motor: "M15.8 7A6.5 6.5 0 1 0 16.5 10M16.5 3v4.2h-4.2M10 11a1 1 0 1 0 0-2 1 1 0 0 0 0 2z",
  gear: "M10 12.6a2.6 2.6 0 1 0 0-5.2 2.6 2.6 0 0 0 0 5.2zM10 2.5v2.6M10 14.9v2.6M2.5 10h2.6M14.9 10h2.6M4.7 4.7l1.8 1.8M13.5 13.5l1.8 1.8M15.3 4.7l-1.8 1.8M6.5 13.5l-1.8 1.8M10 15a5 5 0 1 0 0-10 5 5 0 0 0 0 10z",
  spring: "M2 10h2.5l1.5-4 2.5 8 2.5-8 2.5 8 1.5-4H18",
  force: "M4 16L15 5M9 4.5h6.5V11",
  mass: "M6.8 7h6.4l3 9.5H3.8zM10 7a2.2 2.2 0 1 0 0-4.4A2.2 2.2 0 0 0 10 7z",
  shape: "M4 15L8 5l8 4-4 8zM8 6.5a1.5 1.5 0 1 0 0-3 1.5 1.5 0 0 0 0 3zM16 10.5a1.5 1.5 0 1 0 0-3 1.5 1.5 0 0 0 0 3z",
  delete: "M4 6h12M8 6V3.5h4V6M5.5 6l.8 11h7.4l.8-11M8.5 9v5M11.5 9v5",
  play: "M6 3.5l11 6.5-11 6.5z", pause: "M6 4v12M14 4v12", start: "M5 4v12M16 4.5L8 10l8 5.5z", back: "M14 4.5L6 10l8 5.5z", on: "M6 4.5l8 5.5-8 5.5z",
  ghosts: "M3.5 15L8 5l8.5 3M3.5 15l6.5 1.5L16.5 8", trace: "M3 14c1-9 6-11 8-7s-2 8-4 6 4-9 10-4",
  arrows: "M3 17L9 8M6 8.5h3.2v3.2M9.5 16.5L17 5M13.5 5H17v3.7",
  undo: "M7 4L3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8", redo: "M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12",
  fit: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4", less: "M4 10h12", in: "M10 4v12M4 10h12", out: "M4 10h12",
  theme: "M10 3.5a6.5 6.5 0 1 0 0 13zM10 3.5a6.5 6.5 0 0 1 0 13", help: "M7.5 7.5a2.5 2.5 0 1 1 3.6 2.3c-.8.4-1.1.9-1.1 1.9M10 14.7v.1", close: "M5 5l10 10M15 5L5 15",
  more: "M4.5 10h.1M10 10h.1M15.5 10h.1", file: "M5 2.5h6.5L15.5 7v10.5H5zM11.5 2.5V7h4",
};
const SOLID = new Set(["play", "start", "back", "on"]);

export function icon(name: string): SVGSVGElement {
  return svg("svg", { viewBox: "0 0 20 20", class: SOLID.has(name) ? "icon solid" : "icon", "aria-hidden": "true", focusable: "false" }, svg("path", { d: PATHS[name] ?? "" }));
}
