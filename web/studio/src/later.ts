// Scripts that are loaded when they are first needed; a page in one file has them already.
import { el } from "./dom";

// Returns what loads a script once and answers what it left under a global name; where that fails, it is tried again when it is asked for again.
export function later<T>(script: string, name: string, lacking: string): () => Promise<T> {
  const made = () => (globalThis as unknown as Record<string, T | undefined>)[name];
  let loading: Promise<T> | null = null;
  return () => {
    loading ??= new Promise((resolve, reject) => {
      const ready = made();
      if (ready) return resolve(ready);
      const element = el("script", { src: script });
      element.onload = () => resolve(made()!);
      element.onerror = () => { loading = null; reject(new Error(lacking)); };
      document.head.append(element);
    });
    return loading;
  };
}
