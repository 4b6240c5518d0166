/** The half of the sky above the pearl, seen from above, with a handle for each light. */

import { useRef } from "preact/hooks";
import { type Light, lights, moved } from "../state/camera";
import { editScene, specs } from "../state/store";
import { t } from "../words/speech";

/** Radius of the horizon in the drawing. */
const RIM = 44;
const STEP = 5;

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Where a direction lies in the drawing: you stand below, the middle is overhead. */
export function placeOf(azimuth: number, elevation: number): Place {
  const radius = (RIM * (90 - Math.max(0, elevation))) / 90;
  const angle = (azimuth * Math.PI) / 180;
  return { x: radius * Math.sin(angle), y: radius * Math.cos(angle) };
}

/** The direction of a place in the drawing. */
export function directionOf({ x, y }: Place): { azimuth: number; elevation: number } {
  const radius = Math.min(RIM, Math.hypot(x, y));
  return { azimuth: (Math.atan2(x, y) * 180) / Math.PI, elevation: 90 - (90 * radius) / RIM };
}

const lightName = (light: Light) => t(light.kind, { n: light.number });

export function Dome() {
  const { scene } = specs.value;
  const found = lights(scene);
  const eye = placeOf(scene.camera.azimuth_deg, scene.camera.elevation_deg);
  return (
    <figure class="dome">
      <svg viewBox="-52 -52 104 104" role="group" aria-label={`${t("dome")}. ${t("domeHint")}`}>
        <circle class="rim" r={RIM} />
        <circle class="ring" r={RIM / 2} />
        <path class="ring" d={`M ${-RIM} 0 H ${RIM} M 0 ${-RIM} V ${RIM}`} />
        <circle class="ball" r="6" />
        <path
          class="eye"
          d="M -5 0 L 0 -4 L 5 0 L 0 4 Z"
          transform={`translate(${eye.x} ${eye.y})`}
        >
          <title>{t("eye")}</title>
        </path>
        {found.map((light) => (
          <Handle key={light.path} light={light} />
        ))}
      </svg>
      <figcaption>{found.length > 0 ? t("dome") : t("noLamp")}</figcaption>
    </figure>
  );
}

function Handle({ light }: { light: Light }) {
  const held = useRef(false);
  const { x, y } = placeOf(light.azimuth, light.elevation);
  const put = (azimuth: number, elevation: number) =>
    editScene(light.path, moved(light, azimuth, elevation));
  const keys: Record<string, [side: number, height: number]> = {
    ArrowLeft: [-STEP, 0],
    ArrowRight: [STEP, 0],
    ArrowUp: [0, STEP],
    ArrowDown: [0, -STEP],
  };
  return (
    <g
      class="handle"
      transform={`translate(${x} ${y})`}
      tabindex={0}
      role="slider"
      aria-label={lightName(light)}
      aria-valuemin={-180}
      aria-valuemax={180}
      aria-valuenow={Math.round(light.azimuth)}
      aria-valuetext={t("moveLamp", {
        name: lightName(light),
        azimuth: Math.round(light.azimuth),
        elevation: Math.round(light.elevation),
      })}
      onPointerDown={(event) => {
        held.current = true;
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        const svg = event.currentTarget.ownerSVGElement;
        if (!held.current || svg === null) return;
        const box = svg.getBoundingClientRect();
        const scale = 104 / box.width;
        const place = {
          x: (event.clientX - box.left - box.width / 2) * scale,
          y: (event.clientY - box.top - box.height / 2) * scale,
        };
        const to = directionOf(place);
        put(to.azimuth, to.elevation);
      }}
      onPointerUp={() => (held.current = false)}
      onPointerCancel={() => (held.current = false)}
      onKeyDown={(event) => {
        const by = keys[event.key];
        if (by === undefined) return;
        event.preventDefault();
        put(light.azimuth + by[0], light.elevation + by[1]);
      }}
    >
      <circle class="reach" r="11" />
      {light.kind === "lamp" ? (
        <circle class="light" r="5.5" />
      ) : (
        <rect class="light" x="-5.5" y="-5.5" width="11" height="11" rx="1" />
      )}
    </g>
  );
}
