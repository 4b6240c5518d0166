/** The knobs of the pearl and of its scene. */

import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Kind } from "../specs/spec";
import {
  ESSENTIALS,
  type Group,
  LAMP_KEYS,
  PEARL_GROUPS,
  ROW_KEYS,
  SCENE_GROUPS,
  WINDOW_KEYS,
} from "../state/groups";
import { valueAt } from "../state/path";
import { faults, specs } from "../state/store";
import { addLight, removeLight } from "../state/lights";
import { t } from "../words/speech";
import { Knob } from "./knobs/Knob";

export function PearlKnobs() {
  return (
    <div class="knobs">
      <section class="essentials">
        <h2>{t("essentials")}</h2>
        {ESSENTIALS.map((path) => (
          <Knob key={path} kind="pearl" path={path} />
        ))}
      </section>
      {PEARL_GROUPS.map((group) => (
        <Grouped key={group.title} kind="pearl" group={group} />
      ))}
    </div>
  );
}

export function SceneKnobs() {
  const { scene } = specs.value;
  const [camera, ...others] = SCENE_GROUPS;
  return (
    <div class="knobs">
      {camera !== undefined && <Grouped kind="scene" group={camera} isOpen />}
      <Listed list="lamps" count={scene.lamps.length} keys={LAMP_KEYS} word="lamp" />
      <Listed list="windows" count={scene.windows.length} keys={WINDOW_KEYS} word="window" />
      <div class="row add">
        <button type="button" onClick={() => addLight("lamps")}>
          {t("addLamp")}
        </button>
        <button type="button" onClick={() => addLight("windows")}>
          {t("addWindow")}
        </button>
      </div>
      {others.map((group) => (
        <Grouped key={group.title} kind="scene" group={group} />
      ))}
      <Listed list="rows" count={scene.rows.length} keys={ROW_KEYS} word="row" />
    </div>
  );
}

interface ListedGiven {
  readonly list: "lamps" | "windows" | "rows";
  readonly count: number;
  readonly keys: readonly string[];
  readonly word: "lamp" | "window" | "row";
}

/** A group for each lamp, window or row; keys that stand in the place of others stay away. */
function Listed({ list, count, keys, word }: ListedGiven) {
  return (
    <>
      {Array.from({ length: count }, (_, i) => {
        const paths = keys.map((key) => key.replace(`${list}.`, `${list}.${i}.`));
        const given = paths.filter((path) => valueAt(specs.value.scene, path) !== null);
        return (
          <Fold
            key={i}
            title={t(word, { n: i + 1 })}
            isOpen={(i === 0 && list !== "rows") || isWrong("scene", given)}
          >
            {given.map((path) => (
              <Knob key={path} kind="scene" path={path} />
            ))}
            {list !== "rows" && (
              <button type="button" class="quiet" onClick={() => removeLight(list, i)}>
                {t("removeLight", { name: t(word, { n: i + 1 }) })}
              </button>
            )}
          </Fold>
        );
      })}
    </>
  );
}

function has(kind: Kind, path: string): boolean {
  return valueAt(specs.value[kind], path) !== undefined;
}

function isWrong(kind: Kind, paths: readonly string[]): boolean {
  return faults.value.some((one) => one.kind === kind && paths.includes(one.path));
}

function Grouped({ kind, group, isOpen = false }: { kind: Kind; group: Group; isOpen?: boolean }) {
  const knobs = group.knobs.filter((path) => has(kind, path));
  const physics = group.physics.filter((path) => has(kind, path));
  if (knobs.length + physics.length === 0) return null;
  const title = t(group.title);
  return (
    <Fold
      title={title}
      {...(group.trade === undefined ? {} : { trade: t(group.trade) })}
      isOpen={isOpen || isWrong(kind, [...knobs, ...physics])}
    >
      {knobs.map((path) => (
        <Knob key={path} kind={kind} path={path} />
      ))}
      {physics.length > 0 && (
        <Fold
          class="physics"
          title={t(kind === "pearl" ? "physics" : "more")}
          isOpen={knobs.length === 0 || isWrong(kind, physics)}
        >
          {physics.map((path) => (
            <Knob key={path} kind={kind} path={path} />
          ))}
        </Fold>
      )}
    </Fold>
  );
}

interface FoldGiven {
  readonly title: string;
  readonly trade?: string;
  readonly isOpen: boolean;
  readonly class?: string;
  readonly children: ComponentChildren;
}

/** What is folded away is not there at all: a hundred knobs would be drawn anew at every move. */
function Fold({ title, trade, isOpen, class: kind = "group", children }: FoldGiven) {
  const [shown, setShown] = useState(isOpen);
  useEffect(() => {
    if (isOpen) setShown(true);
  }, [isOpen]);
  return (
    <details class={kind} open={shown} onToggle={(event) => setShown(event.currentTarget.open)}>
      <summary>
        {kind === "group" ? <h2>{title}</h2> : title}
        {trade !== undefined && <span class="trade">{trade}</span>}
      </summary>
      {shown && children}
    </details>
  );
}
