/** All pictures of a sitting, fetched before it begins: a network that is cut stops nobody. */

import { Problem } from "../shared/http";
import type { Api } from "./api";

const AT_ONCE = 4;

export class Pictures {
  private readonly blobs = new Map<string, Blob>();

  constructor(private readonly api: Api) {}

  /** Fetch what is not here yet; `told` hears how many are. Throws `Problem` when one fails. */
  async fetch(names: readonly string[], told: (here: number, all: number) => void) {
    const wanted = names.filter((name) => !this.blobs.has(name));
    const worker = async () => {
      for (let name = wanted.shift(); name !== undefined; name = wanted.shift()) {
        this.blobs.set(name, await this.api.picture(name));
        told(this.blobs.size, names.length);
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE }, worker));
  }

  /** A picture as an image that is decoded: it can be shown within one frame. */
  async decoded(name: string): Promise<HTMLImageElement> {
    const blob = this.blobs.get(name);
    if (blob === undefined) throw new Problem(`picture ${name} was not fetched`, "missing", 404);
    const image = new Image();
    const address = URL.createObjectURL(blob);
    image.src = address;
    image.draggable = false;
    image.alt = "";
    try {
      await image.decode();
    } finally {
      URL.revokeObjectURL(address);
    }
    return image;
  }
}
