/** What happens around a trial that its answer should be marked with. */

export class Watch {
  private readonly over = new AbortController();
  private away = 0;
  private resized = false;

  /** `fit` is called whenever the window has another size. */
  constructor(fit: () => void) {
    const { signal } = this.over;
    let out = false; // a tab that is left both loses the focus and is hidden
    const look = (leaves: boolean) => {
      if (leaves && !out) this.away += 1;
      out = leaves;
    };
    window.addEventListener("blur", () => look(true), { signal });
    window.addEventListener("focus", () => look(false), { signal });
    document.addEventListener("visibilitychange", () => look(document.hidden), { signal });
    window.addEventListener(
      "resize",
      () => {
        this.resized = true;
        fit();
      },
      { signal },
    );
  }

  /** Stop watching. `away`: how often the window lost the focus or was hidden. */
  end(): Record<string, string | number | boolean> {
    this.over.abort();
    return {
      ...(this.away > 0 && { away: this.away }),
      ...(this.resized && { resized: true }),
    };
  }
}
