/** Stands in for specs/ until it is there. */
import complete from "../../../../nacreous/presets/complete.json";
import declared from "../specs/declared.json";
import type { Declaration, Kind, Pearl, Read, Scene, Specs } from "../specs/types";
export type * from "../specs/types";
/* eslint-disable @typescript-eslint/no-explicit-any */
const tables = declared as any;
export function declarations(kind: Kind): readonly Declaration[] {
  const found = new Map<string, Declaration>();
  const walk = (table: string, before: string, model?: any) => {
    for (const [key, one] of Object.entries<any>(tables[table].keys)) {
      const path = before + key;
      const refs = [one, one.items, ...(one.oneOf ?? [])].map((part: any) => part?.$ref);
      const known = refs.filter(Boolean).map((ref: string) => ref.split("/").pop() as string);
      if (known.length > 0 && key !== "aragonite" && key !== "protein") {
        for (const name of known) walk(name, `${path}.`, one.model ?? model);
        continue;
      }
      if (found.has(path)) continue;
      found.set(path, {
        path,
        unit: one.unit ?? "",
        least: one.minimum ?? one.exclusiveMinimum ?? null,
        most: one.maximum === undefined ? (one.exclusiveMaximum ?? null) : Number(one.maximum),
        leastExcluded: false,
        mostExcluded: false,
        allowed: one.allowed,
        files: one.files ?? [],
        isWhole: one.type === "integer",
        choices: one.enum ?? one.examples,
        default: one.default ?? null,
        model: one.model ?? model,
        meaning: one.meaning,
        isOpen: one.open ?? false,
      });
    }
  };
  walk(kind === "pearl" ? "Pearl" : "Scene", "");
  return [...found.values()];
}
export function recipeJson(specs: Specs, size: number, samples: number): string {
  const preset = (complete.scene as any)[specs.scene.name];
  const pearls = (preset?.pearls ?? [null]).map((pearl: unknown) => pearl ?? specs.pearl);
  return JSON.stringify({ pearls, scene: specs.scene, size, samples });
}
export function toToml(_kind: Kind, spec: unknown): string {
  return JSON.stringify(spec);
}
export function open(
  bytes: Uint8Array,
  file: string,
): Read<{ kind: "pearl"; spec: Pearl } | { kind: "scene"; spec: Scene }> {
  try {
    const spec = JSON.parse(new TextDecoder().decode(bytes));
    return { ok: true, value: { kind: "camera" in spec ? "scene" : "pearl", spec } };
  } catch {
    return { ok: false, complaints: [{ path: "", text: `${file}: no TOML` }] };
  }
}
export function toFragment(specs: Specs): Promise<string> {
  return Promise.resolve(encodeURIComponent(JSON.stringify(specs)));
}
export function fromFragment(text: string): Promise<Read<Specs>> {
  try {
    return Promise.resolve({ ok: true, value: JSON.parse(decodeURIComponent(text)) });
  } catch {
    return Promise.resolve({ ok: false, complaints: [{ path: "", text: "no link of ours" }] });
  }
}
