/** Stands in for specs/ until it is there. */
import complete from "../../../../nacreous/presets/complete.json";
import declared from "./declared.json";
import type { Pearl, Scene } from "./complete";
export type { Pearl, Scene } from "./complete";
export type Kind = "pearl" | "scene";
export interface Specs {
  readonly pearl: Pearl;
  readonly scene: Scene;
}
export interface Complaint {
  readonly path: string;
  readonly text: string;
}
export type Read<T> = { ok: true; value: T } | { ok: false; complaints: readonly Complaint[] };
export interface Declaration {
  readonly path: string;
  readonly unit?: string;
  readonly least?: number;
  readonly most?: number;
  readonly leastExcluded?: boolean;
  readonly mostExcluded?: boolean;
  readonly isWhole: boolean;
  readonly choices?: readonly string[];
  readonly default?: unknown;
  readonly model?: string;
  readonly meaning: string;
  readonly isOpen: boolean;
}
/* eslint-disable @typescript-eslint/no-explicit-any */
const tables = declared as any;
export function declarations(kind: Kind): readonly Declaration[] {
  const found = new Map<string, Declaration>();
  const walk = (table: string, before: string, model?: string) => {
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
        unit: one.unit,
        least: one.minimum ?? one.exclusiveMinimum,
        most: one.maximum === undefined ? one.exclusiveMaximum : Number(one.maximum),
        isWhole: one.type === "integer",
        choices: one.enum ?? one.examples,
        default: one.default,
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
export function fromToml(kind: "pearl", text: string, file: string): Read<Pearl>;
export function fromToml(kind: "scene", text: string, file: string): Read<Scene>;
export function fromToml(_kind: Kind, text: string, file: string): Read<any> {
  try {
    return { ok: true, value: JSON.parse(text) };
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
