/** The page: bar, presets, pictures, knobs. */

import { useEffect, useState } from "preact/hooks";
import { openFiles } from "../state/files";
import { board, redo, undo } from "../state/store";
import { openings, reading } from "../state/opened";
import { type Tab, tab } from "../state/view";
import { language, t } from "../words/speech";
import { Bar } from "./Bar";
import { Bench } from "./Bench";
import { Compare, SideSwitch } from "./Compare";
import { PearlKnobs, SceneKnobs } from "./Knobs";
import { Instruments } from "./instruments/Instruments";
import { Opened } from "./Opened";
import { Presets } from "./Presets";

const TABS = [
  ["presets", "tabPresets"],
  ["pearl", "tabPearl"],
  ["scene", "tabScene"],
  ["compare", "tabCompare"],
  ["instruments", "tabInstruments"],
] as const;

export function Page() {
  const isOver = useDropping();
  useKeys();
  useEffect(() => {
    document.documentElement.lang = language.value;
    document.title = t("documentTitle");
  }, [language.value]);
  return (
    <div
      class="page"
      data-tab={tab.value}
      data-openings={openings.value}
      aria-busy={reading.value !== ""}
    >
      <Bar />
      <aside class="left" aria-label={t("tabPresets")}>
        <Presets />
      </aside>
      <main class="middle">
        <Bench />
      </main>
      <Panels />
      <Opened />
      {isOver && <div class="drop">{t("dropHere")}</div>}
    </div>
  );
}

const PANELS: Record<Tab, () => preact.JSX.Element | null> = {
  presets: Presets,
  pearl: PearlKnobs,
  scene: SceneKnobs,
  compare: Compare,
  instruments: Instruments,
};

function Panels() {
  const Shown = PANELS[tab.value];
  const go = (by: number) => {
    const at = TABS.findIndex(([name]) => name === tab.value);
    const next = TABS[(at + by + TABS.length) % TABS.length];
    if (next === undefined) return;
    tab.value = next[0];
    document.getElementById(`tab-${next[0]}`)?.focus();
  };
  return (
    <aside class="right" aria-label={t("panels")}>
      <div class="tabs" role="tablist" aria-label={t("panels")}>
        {TABS.map(([name, word]) => (
          <button
            type="button"
            role="tab"
            key={name}
            id={`tab-${name}`}
            class="tab"
            aria-selected={tab.value === name}
            aria-controls="panel"
            tabIndex={tab.value === name ? 0 : -1}
            onClick={() => (tab.value = name)}
            onKeyDown={(event) => {
              if (event.key === "ArrowRight") go(1);
              if (event.key === "ArrowLeft") go(-1);
            }}
          >
            {t(word)}
          </button>
        ))}
      </div>
      <div
        key={tab.value}
        class="panel"
        id="panel"
        role="tabpanel"
        aria-labelledby={`tab-${tab.value}`}
        tabIndex={-1}
      >
        {board.value.b !== null && tab.value !== "compare" && <SideSwitch />}
        <Shown />
      </div>
    </aside>
  );
}

/** Files dropped anywhere on the page are opened. */
function useDropping(): boolean {
  const [isOver, setOver] = useState(false);
  useEffect(() => {
    const over = (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      setOver(true);
    };
    const leave = (event: DragEvent) => {
      if (event.relatedTarget === null) setOver(false);
    };
    const drop = (event: DragEvent) => {
      event.preventDefault();
      setOver(false);
      void openFiles([...(event.dataTransfer?.files ?? [])]);
    };
    addEventListener("dragover", over);
    addEventListener("dragleave", leave);
    addEventListener("drop", drop);
    return () => {
      removeEventListener("dragover", over);
      removeEventListener("dragleave", leave);
      removeEventListener("drop", drop);
    };
  }, []);
  return isOver;
}

/** Ctrl-Z and Ctrl-Shift-Z, but where text is being typed. */
function useKeys(): void {
  useEffect(() => {
    const key = (event: KeyboardEvent) => {
      const isText = event.target instanceof HTMLInputElement && event.target.type === "text";
      if (!(event.ctrlKey || event.metaKey) || isText) return;
      const pressed = event.key.toLowerCase();
      if (pressed !== "z" && pressed !== "y") return;
      event.preventDefault();
      if (pressed === "y" || event.shiftKey) redo();
      else undo();
    };
    addEventListener("keydown", key);
    return () => removeEventListener("keydown", key);
  }, []);
}
