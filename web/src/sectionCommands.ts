// The section plane by keys: what its handle and its buttons do.

import type { Command } from "./commands";
import type { Settings, SettingsSignal } from "./model/settings";
import type { Stage } from "./view/stage";

/** Share of the model that a key moves the plane by. */
const STEP = 0.02;

const AXES: Settings["sectionAxis"][] = ["x", "y", "z", "free"];

export function sectionCommands(stage: Stage, settings: SettingsSignal): Command[] {
  const command = (id: string, title: string, key: string, run: () => void): Command => ({
    id,
    title: `Section: ${title}`,
    keys: [key],
    group: "Showing",
    isPossible: () => settings.value.section,
    run,
  });
  const move = (step: number) => () => {
    settings.put({ sectionPlace: Math.max(0, Math.min(1, settings.value.sectionPlace + step)) });
  };
  return [
    command("section-back", "plane back", ",", move(-STEP)),
    command("section-forth", "plane forth", ".", move(STEP)),
    command("section-axis", "across the next axis, or the view", "Shift+x", () => {
      const next = AXES[(AXES.indexOf(settings.value.sectionAxis) + 1) % AXES.length];
      settings.put({ sectionAxis: next, sectionNormal: stage.rig.axes()[2].toArray() });
    }),
    command("section-flip", "other side", ";", () => settings.toggle("sectionFlip")),
  ];
}
