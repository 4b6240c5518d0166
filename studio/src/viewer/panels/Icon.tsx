/** Small line drawings of the tools. */

const PATHS = {
  undo: "M8 5 4 9l4 4 M4 9h9a5 5 0 0 1 0 10h-3",
  redo: "M16 5l4 4-4 4 M20 9h-9a5 5 0 0 0 0 10h3",
  reset: "M5 12a7 7 0 1 0 2.2-5.1 M5 4v4h4",
  open: "M4 7v11h16V9h-8l-2-2z",
  save: "M12 4v11 M7 11l5 5 5-5 M5 20h14",
  link: "M10 14l4-4 M8 11l-2.5 2.5a3.5 3.5 0 0 0 5 5L13 16 M16 13l2.5-2.5a3.5 3.5 0 0 0-5-5L11 8",
} as const;

export function Icon({ name }: { name: keyof typeof PATHS }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
