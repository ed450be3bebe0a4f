// Goes through a machine by all calls of the page's door, as door.c does, and hashes every number, status and picture.
// Returns eight hexadecimal digits. `grow` gives the engine that goes on where core.wasm has no more calls.
const encoder = new TextEncoder();

export function walk(engine, text, grow) {
  let call = engine.call;
  let hash = 2166136261;
  const memory = (at, size) => new Uint8Array(call.memory.buffer, at, size);
  const add = (bytes) => { for (const byte of bytes) hash = Math.imul(hash ^ byte, 16777619); };
  const numbers = () => new Float64Array(call.memory.buffer, call.ys_numbers(), call.ys_number_count());
  const addText = () => add(memory(call.ys_text(), call.ys_text_length()));
  const addAll = (status) => {
    add(new Uint8Array(new Float64Array([status]).buffer));
    add(memory(call.ys_numbers(), 8 * call.ys_number_count()));
    addText();
  };
  const put = (words) => {
    const bytes = encoder.encode(words);
    memory(call.ys_input(bytes.length), bytes.length).set(bytes);
  };

  const length = encoder.encode(text).length;
  put(text + "\0machine.yaml");
  const opened = call.ys_open(length), told = JSON.parse(Buffer.from(memory(call.ys_text(), call.ys_text_length())).toString());
  if (opened === 1 && call.ys_scene() === 1) addText();
  if (opened === 1) addAll(call.ys_pose());
  if (opened === 1 && call.ys_number_count() > 0) {
    const { bodies, coordinates } = told.machine, last = bodies.length - 1;
    const k = coordinates.findIndex(({ driven, free }) => driven || free);
    if (k >= 0) {
      const value = numbers()[3 * bodies.length + k];
      for (let step = 1; step <= 4; step++) {
        put(coordinates[k].name + "\0");
        new Float64Array(call.memory.buffer, call.ys_number_room(1), 1)[0] = value + 0.1 * step;
        addAll(call.ys_at(1));
      }
    }
    addAll(call.ys_move_time(0.3));
    const x = numbers()[3 * last], y = numbers()[3 * last + 1];
    addAll(call.ys_drag(last, 0, 0, x + 0.01, y - 0.01));
    call = grow(engine).call;
    put("t\0" + coordinates.map(({ name }) => name + "\0").join(""));
    addAll(call.ys_curves(0, 1, 12));
    put("t\0");
    addAll(call.ys_trace(last, 0.01, 0.02, 0, 1, 12));
    const ghosts = call.ys_ghosts();
    for (let ghost = 0; ghost < ghosts; ghost++) addAll(call.ys_ghost(ghost));
    addAll(call.ys_release());
    for (let step = 0; step < 4; step++) {
      if (step === 1) call.ys_pull(last, 0, 0, x, y, 50);
      addAll(call.ys_step(0.01));
    }
    addAll(call.ys_hold());
  }
  return (hash >>> 0).toString(16).padStart(8, "0");
}
