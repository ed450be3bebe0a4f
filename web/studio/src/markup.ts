// Takes in pictures and formulas that the core wrote. Names in them come from files of strangers: whatever is not on the
// lists below is left out, though the core has escaped it already.
const SVG_NS = "http://www.w3.org/2000/svg", MATH_NS = "http://www.w3.org/1998/Math/MathML", HTML_NS = "http://www.w3.org/1999/xhtml";

const TAGS: Record<string, Set<string>> = {
  [SVG_NS]: new Set(("svg g line polyline polygon path circle ellipse rect text tspan title desc defs marker clippath pattern " +
    "lineargradient radialgradient stop use").split(" ")),
  [MATH_NS]: new Set(("math mrow mi mo mn mtext ms mspace msup msub msubsup mover munder munderover mfrac msqrt mroot mtable mtr mtd " +
    "mstyle mpadded mphantom menclose semantics").split(" ")),
  [HTML_NS]: new Set("h1 h2 h3 h4 p pre code table thead tbody tr td th ul ol li em strong b i sub sup br span div figure figcaption caption".split(" ")),
};
const ATTRIBUTES = new Set(("x y x1 y1 x2 y2 cx cy r rx ry dx dy d points width height viewbox transform fill stroke stroke-width stroke-linejoin " +
  "stroke-linecap stroke-dasharray stroke-opacity fill-opacity opacity paint-order font-family font-size font-weight font-style text-anchor " +
  "dominant-baseline vector-effect class id data-body data-joint data-point data-part data-scale data-origin display xmlns mathvariant stretchy fence separator lspace " +
  "rspace columnalign rowalign columnspacing rowspacing columnlines rowlines frame accent accentunder displaystyle scriptlevel notation colspan rowspan " +
  "clip-path marker-end marker-start marker-mid orient refx refy markerwidth markerheight markerunits offset stop-color visibility clip-rule fill-rule")
  .split(" "));
const STYLE = /^(?:font-weight:\s*bold|font-style:\s*(?:italic|normal)|text-align:\s*(?:left|right|center))?;?$/;

function copy(from: Element): Element | null {
  const space = from.namespaceURI ?? "";
  if (!TAGS[space]?.has(from.localName.toLowerCase())) return null;
  const element = document.createElementNS(space, from.localName);
  for (const { name, value } of Array.from(from.attributes)) {
    const plain = name.toLowerCase();
    if ((plain === "href" && value.startsWith("#")) || (plain === "style" && STYLE.test(value.trim()))) element.setAttribute(name, value);
    else if (ATTRIBUTES.has(plain) && !/url\((?!#)/i.test(value) && plain !== "xmlns") element.setAttribute(name, value);
  }
  append(element, from);
  return element;
}

function append(into: Element | DocumentFragment, from: Element): void {
  for (const child of Array.from(from.childNodes)) {
    const node = child instanceof Element ? copy(child) : child.nodeType === Node.TEXT_NODE ? document.createTextNode(child.textContent!) : null;
    if (node) into.append(node);
  }
}

// Returns the <svg> of a document, or null if it is not one.
export function picture(text: string): SVGSVGElement | null {
  const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  return root.localName === "svg" ? (copy(root) as SVGSVGElement | null) : null;
}

// Returns the elements of a fragment of SVG.
export function pieces(text: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  if (text === "") return fragment;
  const root = new DOMParser().parseFromString(`<svg xmlns="${SVG_NS}">${text}</svg>`, "image/svg+xml").documentElement;
  if (root.localName === "svg") append(fragment, root);
  return fragment;
}

// Returns what the body of a page of formulas holds.
export function formulas(text: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  append(fragment, new DOMParser().parseFromString(text, "text/html").body);
  return fragment;
}
