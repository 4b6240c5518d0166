/** A study file of the chosen pearls, as `nacreous study new` takes it. */

import { stringify } from "smol-toml";
import { type Kind, PEARLS, SCENES, type Specs } from "../specs/spec";
import { type Change, changes } from "./path";
import type { Chosen } from "./tray";

/** A stimulus has at most so many overrides. */
const MOST_OVERRIDES = 100;

interface Near {
  readonly name: string;
  readonly differs: readonly Change[];
}

/** The preset that a spec differs least from, by keys that can be set. */
function nearest(kind: Kind, spec: unknown): Near | null {
  const presets: ReadonlyMap<string, unknown> = kind === "pearl" ? PEARLS : SCENES;
  let best: Near | null = null;
  for (const [name, values] of presets) {
    const differs = changes(values, spec).filter((one) => one.path !== "name");
    if (differs.every(isSettable) && (best === null || differs.length < best.differs.length)) {
      best = { name, differs };
    }
  }
  return best;
}

/** An override changes the single value of a key that is there, and leaves none open. */
function isSettable({ from, to }: Change): boolean {
  const isSingle = typeof to !== "object" || (Array.isArray(to) && typeof to[0] === "number");
  return from !== undefined && to !== undefined && to !== null && isSingle;
}

/** `key=value`, the value as TOML. */
function override({ path, to }: Change): string {
  return stringify({ value: to })
    .trim()
    .replace(/^value = /, `${path}=`);
}

export interface Stimulus {
  readonly label: string;
  readonly pearl: string;
  readonly scene: string;
  readonly overrides: readonly string[];
}

/** A pearl in its scene, by presets and what differs from them; null where that cannot be said. */
export function stimulus(label: string, specs: Specs): Stimulus | null {
  const pearl = nearest("pearl", specs.pearl);
  const scene = nearest("scene", specs.scene);
  if (pearl === null || scene === null) return null;
  const overrides = [...pearl.differs, ...scene.differs].map(override);
  if (overrides.length > MOST_OVERRIDES) return null;
  return { label, pearl: pearl.name, scene: scene.name, overrides };
}

export interface Study {
  readonly toml: string;
  /** Labels of the pearls that no preset and overrides can say. */
  readonly leftOut: readonly string[];
}

/** The study: every pearl against every other, under one question. */
export function studyOf(chosen: readonly Chosen[]): Study {
  const found = chosen.map((one) => ({ ...one, said: stimulus(one.label, one.specs) }));
  const stimuli = found.flatMap(({ said }) => (said === null ? [] : [said]));
  const toml = stringify({
    name: "viewer",
    purpose: "demo",
    languages: ["en", "ja"],
    seed: 1,
    display: { size_px: 512, samples: 16 },
    questions: [
      {
        id: "more-beautiful",
        text: {
          en: "Which pearl is more beautiful?",
          ja: "どちらの真珠がより美しいですか。",
        },
      },
    ],
    stimuli,
  });
  return {
    toml,
    leftOut: found.flatMap(({ label, said }) => (said === null ? [label] : [])),
  };
}
