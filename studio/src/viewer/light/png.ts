/** Texts in a PNG: uncompressed `iTXt` chunks ahead of the pixels, as `crates/file` writes them. */

type Bytes = Uint8Array<ArrayBuffer>;

/** Signature and IHDR, which is the first chunk and 13 bytes long. */
const HEAD = 8 + 4 + 4 + 13 + 4;

/** The PNG with texts, each by its keyword. */
export function withTexts(
  png: Bytes,
  texts: readonly (readonly [keyword: string, text: string])[],
): Bytes {
  const parts = [png.subarray(0, HEAD), ...texts.map(textChunk), png.subarray(HEAD)];
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Keyword, a zero, not compressed (two zeros), no language, no other keyword, and the text. */
function textChunk([keyword, text]: readonly [string, string]): Bytes {
  const body = new TextEncoder().encode(`iTXt${keyword}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(body.length + 8);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, body.length - 4);
  chunk.set(body, 4);
  view.setUint32(body.length + 4, crc32(body));
  return chunk;
}

/** The check of PNG's chunks (ISO 3309). */
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}
