// Completions: the format's keys at their place, and the file's own names.
import type { CompletionContext, CompletionResult, CompletionSource } from "@codemirror/autocomplete";
import type { Session } from "../session";
import { words } from "../words";

const TOP = ["name", "units", "parameters", "gravity", "bodies", "joints", "gears", "racks", "belts", "cams", "laws", "forces", "springs",
  "stops", "locks", "drives", "efforts", "start"];
const INSIDE: Record<string, string[]> = {
  bodies: ["points", "mass", "center", "inertia", "rod"],
  joints: ["pin", "slide", "pin-slot", "weld", "free", "angle", "distance", "along", "from", "to", "at", "turned", "friction"],
  units: ["length", "mass", "time", "angle", "force"],
  gears: ["mesh", "teeth", "module", "pressure_angle", "carrier", "internal"],
  racks: ["pinion", "rack", "radius"],
  belts: ["between", "radii", "crossed"],
  cams: ["cam", "follower", "law", "roller", "base", "offset"],
  forces: ["body", "at", "value", "axes"],
  springs: ["between", "along", "stiffness", "length", "damping"],
  laws: ["period", "segments"],
};

// Returns the section (a key in the first column) in which a line stands.
function sectionAt(context: CompletionContext): string {
  const { doc } = context.state;
  for (let line = doc.lineAt(context.pos).number; line >= 1; line--) {
    const key = doc.line(line).text.match(/^([A-Za-z_]+)\s*:/);
    if (key) return key[1];
  }
  return "";
}

export const complete = (session: () => Session): CompletionSource => (context: CompletionContext): CompletionResult | null => {
  const word = context.matchBefore(/[A-Za-z_][\w.-]*/);
  if (!word && !context.explicit) return null;
  const from = word?.from ?? context.pos, line = context.state.doc.lineAt(from);
  if (line.text.slice(0, from - line.from).includes("#")) return null;
  if (from === line.from) return { from, options: TOP.map((label) => ({ label, apply: `${label}: `, type: "keyword" })) };
  const section = sectionAt(context), machine = session().machine;
  const keys = (INSIDE[section] ?? []).map((label) => ({ label, detail: words.editor.key, type: "keyword" }));
  const names = machine ? [
    ...machine.bodies.map((body) => ({ label: body.name, detail: words.editor.body, type: "class" })),
    ...machine.parameters.map((one) => ({ label: one.name, detail: words.editor.parameter, type: "variable" })),
    ...machine.coordinates.map((one) => ({ label: one.name, detail: words.editor.coordinate, type: "property" })),
    ...Array.from(new Set(machine.bodies.flatMap((body) => body.points.map((point) => point.name))), (label) => ({ label, detail: words.editor.point, type: "constant" })),
  ] : [];
  return { from, options: [...keys, ...names], validFor: /^[\w.-]*$/ };
};
