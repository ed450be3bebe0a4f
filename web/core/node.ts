// What tests in Node use of the core, without a worker.
export { Engine, OutOfMemory } from "./engine";
export { REPORT_SCRIPT, runCommand } from "./wasi";
export { startCore } from "./client";
export { CoreLost, Overtaken } from "./door";
export { serve } from "./worker";
