/** A field that takes what fits as it is typed, and says of the rest why it was not taken. */

import { useState } from "preact/hooks";
import type { Declaration } from "../../specs/spec";
import { allowedJa, quotedJa } from "../../words/allowed";
import { language, nameOf, t } from "../../words/speech";

interface Given<T> {
  readonly id?: string;
  readonly label?: string;
  readonly describedBy?: string;
  readonly class?: string;
  readonly inputMode?: "decimal" | "numeric" | "text";
  readonly placeholder?: string;
  /** The value as the field shows it while nothing is typed. */
  readonly shown: string;
  /** The value of a text; undefined where it is refused. */
  readonly read: (text: string) => T | undefined;
  readonly set: (value: T) => void;
  /** What may be typed, in words. */
  readonly allowed: string;
}

export function Typed<T>({ shown, read, set, allowed, ...given }: Given<T>) {
  const [draft, setDraft] = useState<string | null>(null);
  /** What was typed last and not taken; it is told until something else is typed or set. */
  const [left, setLeft] = useState<{ readonly text: string; readonly shown: string } | null>(null);
  const isWrong = draft !== null && read(draft) === undefined;
  const end = () => {
    if (draft !== null) setLeft(isWrong ? { text: draft, shown } : null);
    setDraft(null);
  };
  const told = left !== null && left.shown === shown ? left.text : null;
  const wrongId = given.id === undefined ? undefined : `${given.id}-wrong`;
  return (
    <span class="typed">
      <input
        {...(given.id === undefined ? {} : { id: given.id })}
        type="text"
        class={given.class ?? ""}
        inputMode={given.inputMode ?? "text"}
        autocomplete="off"
        {...(given.placeholder === undefined ? {} : { placeholder: given.placeholder })}
        {...(given.label === undefined ? {} : { "aria-label": given.label })}
        aria-describedby={[given.describedBy, wrongId].filter(Boolean).join(" ")}
        aria-invalid={isWrong}
        value={draft ?? shown}
        onInput={(event) => {
          const text = event.currentTarget.value;
          setDraft(text);
          setLeft(null);
          const next = read(text);
          if (next !== undefined) set(next);
        }}
        onBlur={end}
        onKeyDown={(event) => {
          if (event.key === "Enter" && !event.isComposing) end();
        }}
      />
      <span class="range" {...(wrongId === undefined ? {} : { id: wrongId })} role="status">
        {isWrong && allowed}
        {!isWrong &&
          told !== null &&
          t("notTaken", { text: told === "" ? "–" : t("quoted", { text: told }), allowed })}
      </span>
    </span>
  );
}

/** What a key allows, in the page's language. */
export function allowedOf({ allowed }: Declaration): string {
  if (language.value !== "ja") return allowed;
  return quotedJa(allowedJa(allowed, nameOf) ?? allowed);
}
