/** What a pair looks like, and how it is answered: by touch, click or key. */

import { button, element } from "../../../shared/dom";
import type { Chosen } from "../../api";
import { progress } from "../../progress";
import type { Room } from "../../sizes";

export interface PairWords {
  question: string;
  left: string;
  right: string;
  tie: string;
  /** Such as "3 of 21". */
  progress: string;
  /** Said when somebody answers before the pictures were seen long enough. */
  early: string;
  /** What keys there are. */
  keys: string;
}

export interface Sizes {
  left: Room;
  right: Room;
  shrunk: number;
}

interface Answered {
  chosen: Chosen;
  took_ms: number;
  /** How often an answer came before the least time of viewing. */
  early: number;
}

const KEYS: Record<string, Chosen> = {
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowDown: "tie",
  "=": "tie",
};

export class PairView {
  readonly root: HTMLElement;
  private readonly room = element("div", { class: "pictures hidden" });
  private readonly hint = element("p", { class: "hint", role: "status" });
  private readonly frames: Record<"left" | "right", HTMLButtonElement>;
  private respond: (chosen: Chosen, at_ms: number) => void = () => undefined;

  constructor(
    private readonly words: PairWords,
    share: number,
    private readonly ties: boolean,
    private readonly left: HTMLImageElement,
    private readonly right: HTMLImageElement,
    private readonly sizes: (room: Room) => Sizes,
  ) {
    this.frames = { left: this.choice("left", left), right: this.choice("right", right) };
    const cross = element("div", { class: "cross", "aria-hidden": "true" });
    this.room.append(this.frames.left, cross, this.frames.right);
    const below = element(
      "div",
      { class: "below" },
      ...(ties ? [this.choice("tie")] : []),
      this.hint,
    );
    this.hint.textContent = words.keys;
    this.root = element(
      "section",
      { class: "pair", "aria-labelledby": "question" },
      element("h1", { id: "question" }, words.question),
      this.room,
      below,
      progress(words.progress, share),
    );
  }

  /** Give the pictures their sizes for the room there is; returns by how much they are shrunk. */
  fit(): number {
    const sizes = this.sizes({
      width_px: this.room.clientWidth,
      height_px: this.room.clientHeight,
    });
    for (const [image, size] of [
      [this.left, sizes.left],
      [this.right, sizes.right],
    ] as const) {
      image.style.width = `${size.width_px}px`;
      image.style.height = `${size.height_px}px`;
    }
    return sizes.shrunk;
  }

  /** Show both pictures in one frame, without the cross; resolves to that frame's time. */
  reveal(): Promise<number> {
    return new Promise((resolve) => {
      requestAnimationFrame((frame_ms) => {
        this.room.classList.remove("hidden");
        resolve(frame_ms);
      });
    });
  }

  /** Wait for an answer that comes no earlier than `minimum_ms` after `shown_ms`. */
  answer(shown_ms: number, minimum_ms: number): Promise<Answered> {
    const over = new AbortController();
    let early = 0;
    return new Promise((resolve) => {
      this.respond = (chosen, at_ms) => {
        if (!this.root.isConnected || over.signal.aborted) return;
        const took_ms = at_ms - shown_ms;
        if (took_ms < minimum_ms) {
          early += 1;
          this.hint.textContent = this.words.early;
          return;
        }
        over.abort();
        this.room.classList.add("over");
        resolve({ chosen, took_ms, early });
      };
      document.addEventListener("keydown", (event) => this.press(event), { signal: over.signal });
    });
  }

  /** What a simulated participant does: a click, or for "no difference" its key. */
  act(chosen: Chosen): void {
    if (chosen !== "tie") this.frames[chosen].click();
    else document.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowDown" }));
  }

  private press(event: KeyboardEvent): void {
    const chosen = KEYS[event.key];
    const plain = !event.repeat && !event.ctrlKey && !event.altKey && !event.metaKey;
    if (chosen === undefined || !plain || (chosen === "tie" && !this.ties)) return;
    event.preventDefault();
    this.respond(chosen, event.timeStamp);
  }

  private choice(chosen: Chosen, image?: HTMLImageElement): HTMLButtonElement {
    const made = button(image ? "" : this.words[chosen], () => undefined, {
      class: image ? "picture" : "quiet",
      ...(image && { "aria-label": this.words[chosen] }),
    });
    made.addEventListener("click", (event) => this.respond(chosen, event.timeStamp));
    if (image) made.append(image);
    return made;
  }
}
