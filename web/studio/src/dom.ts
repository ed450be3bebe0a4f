// Makes elements of the page: el("button", {class: "quiet", onclick: ...}, "Text").
type Child = Node | string | null | undefined | false;
type Props = Record<string, unknown>;

function dress(element: Element, props: Props, children: Child[]): void {
  for (const [key, value] of Object.entries(props)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value as EventListener);
    else if (key === "value" || key === "checked" || key === "disabled" || key === "hidden") Object.assign(element, { [key]: value });
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
}

export function el<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  dress(element, props, children);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  dress(element, props, children);
  return element;
}

export const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

// Replaces what an element holds.
export const fill = (element: Element, ...children: Child[]): void =>
  element.replaceChildren(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));

export const isTyping = (event: Event): boolean =>
  (event.target as HTMLElement | null)?.closest?.("input:not([type=range]):not([type=checkbox]), textarea, select, .cm-editor, dialog") != null;

// Runs a function once a frame at most, with the last call's meaning.
export function eachFrame(run: () => void): () => void {
  let asked = 0;
  return () => {
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      run();
    });
  };
}
