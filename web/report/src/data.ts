// The data that the program wrote into the page (src/report/data.c): numbers of every row of the motion.
export interface Column { name: string; unit: string; values: (number | null)[] }
export interface Panel { id: string; unit: string; columns: number[] }
export interface Body { name: string; center: [number, number]; x: number[]; y: number[]; turn: number[] }
export interface Place { body: number; at: [number, number] }
export interface Joint extends Place { name: string; columns: number[] }
// turned: the angle by which the drawing turns a follower from its place in the velocities, clockwise, rad
export interface Point extends Place { name: string; point: number; shown: boolean; turned: number; columns: number[] }

export interface Data {
  seconds: number; // of one pass
  goes_back: boolean; // back and forth
  start: number; // the row drawn at first
  axis: Column;
  columns: Column[];
  panels: Panel[];
  readout: [number, number, number][];
  bodies?: Body[];
  joints?: Joint[];
  middles?: Place[];
  points?: Point[];
}

export function readData(): Data {
  return JSON.parse(document.getElementById("data")!.textContent!) as Data;
}

// Interpolates linearly between two rows; null if either value is unknown.
export function between(values: (number | null)[], at: number): number | null {
  const row = Math.min(Math.floor(at), values.length - 1), part = at - row;
  const a = values[row], b = part > 0 ? values[row + 1] : a;
  return a === null || b === null || b === undefined ? null : a + (b - a) * part;
}

export function number(value: number | null): string {
  return value === null ? "–" : String(Number(value.toPrecision(6)));
}
