// TypeScript from the schemas that schemas.py prints: node typescript.mjs FOLDER < SCHEMAS.

import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { text } from "node:stream/consumers";

import { compile } from "json-schema-to-typescript";
import { resolveConfig } from "prettier";

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

for (const [name, { sha256, schema }] of Object.entries(JSON.parse(await text(process.stdin)))) {
  const made = await compile(older(schema), name, {
    additionalProperties: false,
    bannerComment: `/* Made by ./just types, never by hand. SHA-256 of its schema:\n * ${sha256}\n */`,
    style,
    unreachableDefinitions: true,
  });
  const clean = NOISE.reduce((kept, noise) => kept.replace(noise, ""), made);
  await writeFile(join(folder, `${name}.ts`), clean);
}
