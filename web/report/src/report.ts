// The report's script: makes the drawing move and draws the diagrams.
import { Arrows } from "./arrows";
import { Charts } from "./charts";
import { readData } from "./data";
import { Player } from "./player";
import { Pose } from "./pose";
import { Readout } from "./readout";
import { addShows } from "./shows";

const data = readData();
const svg = document.querySelector<SVGSVGElement>("#stage svg");
let charts: Charts | null = null;
let player: Player | null = null;

if (svg && data.bodies) {
  const pose = new Pose(data, svg), readout = new Readout(data, document.getElementById("readout")!);
  const arrows = { velocities: new Arrows(data, svg, "velocity", data.points!), forces: new Arrows(data, svg, "force", data.joints!) };
  const all = Object.values(arrows);
  player = new Player(data, (at) => {
    pose.show(at);
    readout.show(at);
    for (const each of all) each.show(at);
    charts?.show(at);
  });
  addShows(data, svg, arrows, () => player!.at);
}
// The page appears first, the diagrams afterwards.
if (data.panels.length > 0)
  requestAnimationFrame(() => setTimeout(() => {
    charts = new Charts(data, (row) => { player?.play(false); player?.go(row); });
    charts.show(player?.at ?? 0);
  }));
