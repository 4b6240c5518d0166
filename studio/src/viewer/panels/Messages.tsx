/** What is wrong with a file, and short notices that go by themselves: over the picture, on no control. */

import { useEffect } from "preact/hooks";
import { reading } from "../state/opened";
import { notice, offersUndo, refused, undo } from "../state/store";
import { fileSays } from "../words/complaints";
import { fileWord } from "../words/files";
import { t } from "../words/speech";
import { Said } from "./Said";

/** How long a notice stays; longer where something can be done about it. */
const NOTICE_MS = 7000;
const OFFER_MS = 20_000;
const MOST_LINES = 6;

export function Messages() {
  return (
    <div class="messages">
      <Refused />
      <Notice />
    </div>
  );
}

function Refused() {
  if (refused.value === null || refused.value.complaints.length === 0) return null;
  const { complaints, from } = refused.value;
  const more = complaints.length - MOST_LINES;
  return (
    <div class="message wrong" role="alert">
      <div class="head">
        <strong>{t(from === "file" ? "refusedFile" : "refusedLink")}</strong>
        <button type="button" onClick={() => (refused.value = null)}>
          {t("close")}
        </button>
      </div>
      <ul>
        {complaints.slice(0, MOST_LINES).map((one) => (
          <li key={one.text}>
            <Said {...fileSays(one)} />
          </li>
        ))}
        {more > 0 && <li>{fileWord("andSo", { n: more })}</li>}
      </ul>
    </div>
  );
}

function Notice() {
  const isUndo = offersUndo.value && notice.value !== "";
  const said = reading.value === "" ? notice.value : fileWord("reading", { name: reading.value });
  useEffect(() => {
    if (said === "") return;
    const gone = setTimeout(() => (notice.value = ""), isUndo ? OFFER_MS : NOTICE_MS);
    return () => clearTimeout(gone);
  }, [said, isUndo]);
  return (
    <div class={said === "" ? "" : "message notice"}>
      <span role="status">{said}</span>
      {isUndo && (
        <button type="button" onClick={undo}>
          {t("undo")}
        </button>
      )}
    </div>
  );
}
