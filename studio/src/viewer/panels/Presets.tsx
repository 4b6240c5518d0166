/** Pearls and scenes to begin with, as small pictures. */

import { useEffect, useRef, useState } from "preact/hooks";
import { put } from "../light/screen";
import { PEARLS, SCENES, type Specs } from "../specs/spec";
import { SPACE, smallPicture } from "../state/engines";
import { FEATURED, SCENE_ORDER } from "../state/presets";
import { specs, take } from "../state/store";
import { PEARL_NAMES, SCENE_NAMES } from "../words/presets";
import { language, t } from "../words/speech";

export function Presets() {
  const [all, setAll] = useState(false);
  const rest = [...PEARLS.keys()].filter((name) => !FEATURED.includes(name));
  const scene = SCENES.get("north-window-black");
  const pearl = PEARLS.get("akoya-rg");
  if (scene === undefined || pearl === undefined) return null;
  return (
    <div class="presets">
      <section>
        <h2>{t("scenes")}</h2>
        <ul class="grid">
          {SCENE_ORDER.map((name) => {
            const found = SCENES.get(name);
            return (
              found && (
                <Choice
                  key={name}
                  name={SCENE_NAMES[name]?.[language.value] ?? name}
                  specs={{ pearl, scene: found }}
                  isTaken={specs.value.scene.name === name}
                  onTake={() => take("scene", found)}
                />
              )
            );
          })}
        </ul>
      </section>
      <section>
        <h2>{t("pearls")}</h2>
        <ul class="grid">
          {[...FEATURED, ...(all ? rest : [])].map((name) => {
            const found = PEARLS.get(name);
            return (
              found && (
                <Choice
                  key={name}
                  name={PEARL_NAMES[name]?.[language.value] ?? name}
                  specs={{ pearl: found, scene }}
                  isTaken={specs.value.pearl.name === name}
                  onTake={() => take("pearl", found)}
                />
              )
            );
          })}
        </ul>
        <button type="button" class="quiet more" aria-expanded={all} onClick={() => setAll(!all)}>
          {all ? t("fewer") : t("moreOf", { n: rest.length })}
        </button>
      </section>
    </div>
  );
}

interface ChoiceGiven {
  readonly name: string;
  readonly specs: Specs;
  readonly isTaken: boolean;
  readonly onTake: () => void;
}

function Choice({ name, specs, isTaken, onTake }: ChoiceGiven) {
  return (
    <li>
      <button type="button" class="choice" aria-pressed={isTaken} onClick={onTake}>
        <SmallPicture specs={specs} />
        <span>{name}</span>
      </button>
    </li>
  );
}

/** A small picture, once there is time to make it; until then the last one stays. */
export function SmallPicture({ specs }: { specs: Specs }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [state, setState] = useState<"empty" | "before" | "">("empty");
  useEffect(() => {
    let wanted = true;
    setState((was) => (was === "empty" ? was : "before"));
    void smallPicture(specs).then((made) => {
      if (!wanted || made === null || canvas.current === null) return;
      put(canvas.current, made.codes, made.widthPx, SPACE);
      setState("");
    });
    return () => {
      wanted = false;
    };
  }, [specs.pearl, specs.scene]);
  return <canvas ref={canvas} class={`small ${state}`} width={2} height={2} aria-hidden="true" />;
}
