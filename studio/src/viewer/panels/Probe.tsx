/** A picture with a probe that pointer and arrow keys move. */

import { fileWord } from "../words/files";

export interface Place {
  readonly column: number;
  readonly row: number;
}

interface Given {
  readonly canvas: { current: HTMLCanvasElement | null };
  readonly size: { readonly width: number; readonly height: number };
  readonly place: Place | null;
  readonly move: (place: Place) => void;
}

const STEPS: Readonly<Record<string, readonly [right: number, down: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const FAR = 10;

export function Probe({ canvas, size: { width, height }, place, move }: Given) {
  const within = (value: number, count: number) =>
    Math.max(0, Math.min(count - 1, Math.floor(value)));
  const to = (column: number, row: number) =>
    move({ column: within(column, width), row: within(row, height) });
  const point = (event: PointerEvent) => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const [right, down] = [event.clientX - box.left, event.clientY - box.top];
    to((right / box.width) * width, (down / box.height) * height);
  };
  const key = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const by = event.shiftKey ? FAR : 1;
    const from = place ?? { column: width / 2, row: height / 2 };
    to(from.column + by * step[0], from.row + by * step[1]);
  };
  return (
    <div class="probed">
      <canvas
        ref={canvas}
        width={width}
        height={height}
        tabIndex={0}
        role="img"
        aria-label={fileWord("probe")}
        onPointerMove={point}
        onPointerDown={point}
        onKeyDown={key}
      />
      {place !== null && (
        <i
          class="cross"
          aria-hidden="true"
          style={{
            left: `${((place.column + 0.5) / width) * 100}%`,
            top: `${((place.row + 0.5) / height) * 100}%`,
          }}
        />
      )}
    </div>
  );
}
