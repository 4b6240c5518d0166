// The generated files of what schemas.py prints: node typescript.mjs FOLDER < PRINTED.

import { mkdir, writeFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { text } from "node:stream/consumers";

import { compile } from "json-schema-to-typescript";
import { format, resolveConfig } from "prettier";

/**
 * A schema as json-schema-to-typescript understands it: it knows tuples as drafts before 2020 wrote
 * them, and takes a reference with a description of its own for another type.
 */
function older(schema) {
  if (Array.isArray(schema)) return schema.map(older);
  if (typeof schema !== "object" || schema === null) return schema;
  const { $ref, minItems, maxItems, prefixItems, ...rest } = schema;
  const made = Object.fromEntries(Object.entries(rest).map(([key, value]) => [key, older(value)]));
  if (prefixItems) Object.assign(made, { items: older(prefixItems), minItems, maxItems });
  if ($ref) return Object.keys(rest).length > 0 ? { ...made, allOf: [{ $ref }] } : { $ref };
  return made;
}

/** What the generator says of itself, and the root of all schemas, which is no type. */
const NOISE = [
  / \*(\n \*)? This interface was referenced by `\w+`'s JSON-Schema\n \* via the `definition` "\w+"\.\n/g,
  /\/\*\*\n \*\/\n/g,
  /export interface \w+ {\n {2}\[k: string\]: unknown;\n}\n/g,
];

const [folder] = process.argv.slice(2);
const style = await resolveConfig(import.meta.filename);

async function typescript(name, { sha256, schema }) {
  const made = await compile(older(schema), basename(name, ".ts"), {
    additionalProperties: false,
    bannerComment: `/* Made by ./just types, never by hand. SHA-256 of its schema:\n * ${sha256}\n */`,
    style,
    unreachableDefinitions: true,
  });
  return NOISE.reduce((kept, noise) => kept.replace(noise, ""), made);
}

for (const [name, made] of Object.entries(JSON.parse(await text(process.stdin)))) {
  const path = join(folder, name);
  await mkdir(dirname(path), { recursive: true });
  const { values } = made;
  const written = values
    ? await format(JSON.stringify(values), { ...style, parser: "json" })
    : await typescript(name, made);
  await writeFile(path, written);
}
