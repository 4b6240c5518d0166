/** Where the focus goes when the control that had it goes away. */

/** Focuses what a selector finds once the page is drawn anew. */
export function focusNext(selector: string): void {
  requestAnimationFrame(() =>
    requestAnimationFrame(() => {
      if (document.activeElement === document.body) {
        document.querySelector<HTMLElement>(selector)?.focus();
      }
    }),
  );
}
