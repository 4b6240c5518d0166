/** The bar at the top: undo, files, link, language. */

import { useEffect, useRef, useState } from "preact/hooks";
import { NAMES } from "../../shared/language";
import { copyLink, openFiles, saveToml } from "../state/files";
import { canRedo, canUndo, redo, resetAll, undo } from "../state/store";
import { language, speak, t } from "../words/speech";
import { fileWord } from "../words/files";
import { saveActiveExr, saveActivePng } from "./Bench";
import { Icon } from "./Icon";

export function Bar() {
  const picker = useRef<HTMLInputElement>(null);
  const other = language.value === "ja" ? "en" : "ja";
  return (
    <header class="bar">
      <h1>{t("title")}</h1>
      <div class="tools" role="toolbar" aria-label={t("title")}>
        <Tool icon="undo" label={t("undo")} isOff={!canUndo.value} act={undo} />
        <Tool icon="redo" label={t("redo")} isOff={!canRedo.value} act={redo} />
        <Tool icon="reset" label={t("reset")} act={resetAll} />
        <span class="gap" />
        <Tool icon="open" label={t("open")} act={() => picker.current?.click()} />
        <Save />
        <Tool
          icon="link"
          label={t("link")}
          act={() => void copyLink({ copied: t("linkCopied"), shown: t("linkShown") })}
        />
        <button type="button" class="tool language" lang={other} onClick={() => speak(other)}>
          {NAMES[other]}
        </button>
      </div>
      <input
        ref={picker}
        type="file"
        accept=".toml,.hdr,.exr,.png,.jpg,.jpeg,.tif,.tiff,.csv"
        multiple
        hidden
        aria-label={t("open")}
        onChange={(event) => {
          void openFiles([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
    </header>
  );
}

interface ToolGiven {
  readonly icon: Parameters<typeof Icon>[0]["name"];
  readonly label: string;
  readonly isOff?: boolean;
  readonly act: () => void;
}

function Tool({ icon, label, isOff = false, act }: ToolGiven) {
  return (
    <button
      type="button"
      class="tool"
      title={label}
      aria-label={label}
      disabled={isOff}
      onClick={act}
    >
      <Icon name={icon} />
      <span class="name">{label}</span>
    </button>
  );
}

/** What can be saved; closed by Escape or a press elsewhere. */
function Save() {
  const [isOpen, setOpen] = useState(false);
  const here = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!isOpen) return;
    const close = (event: Event) => {
      const isKey = event instanceof KeyboardEvent;
      if (isKey ? event.key === "Escape" : !here.current?.contains(event.target as Node)) {
        setOpen(false);
      }
    };
    document.addEventListener("pointerdown", close);
    document.addEventListener("keydown", close);
    return () => {
      document.removeEventListener("pointerdown", close);
      document.removeEventListener("keydown", close);
    };
  }, [isOpen]);
  const item = (label: string, act: () => void) => (
    <button
      type="button"
      onClick={() => {
        act();
        setOpen(false);
      }}
    >
      {label}
    </button>
  );
  return (
    <div class="menu" ref={here}>
      <button
        type="button"
        class="tool"
        title={t("save")}
        aria-label={t("save")}
        aria-expanded={isOpen}
        onClick={() => setOpen(!isOpen)}
      >
        <Icon name="save" />
        <span class="name">{t("save")}</span>
      </button>
      {isOpen && (
        <div class="items">
          {item(t("savePng"), saveActivePng)}
          {item(fileWord("saveExr"), saveActiveExr)}
          {item(t("savePearl"), () => saveToml("pearl"))}
          {item(t("saveScene"), () => saveToml("scene"))}
        </div>
      )}
    </div>
  );
}
