// Lengths and angles between SI and the words of a file.
import { Source } from "./source";

const METRES: Record<string, number> = { m: 1, mm: 1e-3, cm: 1e-2, um: 1e-6, km: 1e3, in: 0.0254, ft: 0.3048 };
const DEGREE = Math.PI / 180;

export interface Units { length: string; metre: number; angle: string }

export function unitsOf(source: Source): Units {
  const length = source.value(["units", "length"]) ?? "m";
  return { length: length in METRES ? length : "m", metre: METRES[length] ?? 1, angle: source.value(["units", "angle"]) ?? "rad" };
}

// Rounds to a decimal place and prints without trailing zeros.
export function decimal(value: number, step: number): string {
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
  const text = value.toFixed(digits);
  return String(Number(text)).includes("e") ? text : String(Number(text));
}

// Writes a length in the file's unit, to a resolution in metres.
export const length = (metres: number, units: Units, resolution: number): string =>
  decimal(metres / units.metre, Math.min(1, resolution / units.metre));

export const point = (at: readonly [number, number], units: Units, resolution: number): string =>
  `[${length(at[0], units, resolution)}, ${length(at[1], units, resolution)}]`;

export function angle(radians: number, units: Units): string {
  const degrees = decimal(radians / DEGREE, 1e-3);
  return units.angle === "deg" ? degrees : `${degrees} deg`;
}

export interface Typed { length?: number; angle?: number }

// Reads what is typed while drawing: `120`, `120 mm`, `120 mm 30 deg`, `30 deg`. A length is in metres then; null if
// it is neither.
export function typed(text: string, units: Units): Typed | null {
  const answer: Typed = {}, parts = text.trim().replace(/[,@<]/g, " ").match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?\s*[a-z°"]*/gi);
  if (!parts || parts.join("").replace(/\s/g, "") !== text.replace(/[,@<\s]/g, "")) return null;
  for (const part of parts) {
    const value = parseFloat(part), unit = part.trim().replace(/^[-+\d.]+(?:e[-+]?\d+)?\s*/i, "");
    if (unit === "deg" || unit === "°" || (unit === "" && answer.length !== undefined)) answer.angle = value * DEGREE;
    else if (unit === "rad") answer.angle = value;
    else if (unit === "" && value > 0) answer.length = value * units.metre;
    else if (unit in METRES && value > 0) answer.length = value * METRES[unit];
    else return null;
  }
  return answer;
}
