/** A sentence, marked where it is in another language than the page. */

import type { Sentence } from "../words/sentence";

export function Said({ lead, text, lang }: Sentence) {
  return (
    <>
      {lead}
      <span lang={lang}>{text}</span>
    </>
  );
}
