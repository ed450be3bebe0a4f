// A page in one file (`yoke studio FILE -o page.html`) brings its worker, modules, machine and files with it.
export interface Inline {
  worker: string;
  small: Uint8Array<ArrayBuffer>;
  whole: Uint8Array<ArrayBuffer>;
  report: Uint8Array<ArrayBuffer>; // the script of reports
  machine: { name: string; text: string } | null;
  files: Record<string, string>;
}
declare const yokeInline: Inline | undefined;
export const inline: Inline | null = typeof yokeInline === "undefined" ? null : yokeInline;
