// Machines of very many links, as files.

// Parallelograms to and fro over a square, each on the last: `links` cranks and couplers, one freedom.
export function rowOf(links) {
  const wide = Math.ceil(Math.sqrt(links / 2)), at = (k) => { const row = Math.floor(k / wide), column = k % wide; return [1.5 * (row % 2 ? wide - 1 - column : column), 1.5 * row]; };
  const cells = Math.floor(links / 2), ground = [], bodies = [], joints = [], start = [];
  for (let k = 0; k <= cells; k++) {
    ground.push(`O${k}: [${at(k)}]`);
    bodies.push(`  c${k}: {points: {O${k}: [0, 0], A${k}: [1, 0]}}`);
    joints.push(`  O${k}: {pin: [ground, c${k}], angle: t${k}}`);
    start.push(`t${k}: 1.2`);
    if (k === cells) break;
    bodies.push(`  r${k}: {points: {A${k}: [0, 0], A${k + 1}: [${at(k + 1)[0] - at(k)[0]}, ${at(k + 1)[1] - at(k)[1]}]}}`);
    joints.push(`  A${k}: {pin: [c${k}, r${k}]}`, `  B${k}: {pin: [r${k}, c${k + 1}], at: A${k + 1}}`);
  }
  return `bodies:\n  ground: {points: {${ground.join(", ")}}}\n${bodies.join("\n")}\njoints:\n${joints.join("\n")}\ndrives: {t0: 1.2 + 0.5 * sin(2 rad/s * t)}\nstart: {${start.join(", ")}}\n`;
}

// A chain whose first link is driven.
export function chainOf(links) {
  let bodies = "bodies:\n  ground: {points: {J0: [0, 0]}}\n", joints = "joints:\n";
  for (let k = 0; k < links; k++) {
    bodies += `  b${k}: {points: {J${k}: [0, 0], J${k + 1}: [0.1, 0]}}\n`;
    joints += `  J${k}: {pin: [${k ? "b" + (k - 1) : "ground"}, b${k}], angle: t${k}}\n`;
  }
  return `${bodies}${joints}drives: {t0: 6 rpm * t}\n`;
}
