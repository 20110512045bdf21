// Kind 1: one PNG, decoded off the main thread.
import { HEADER_BYTES } from "../protocol/frame_header";

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

/** The PNG in an image frame; throws where the payload is something else. */
export function pngOf(message: ArrayBuffer): Blob {
  const png = new Uint8Array(message, HEADER_BYTES);
  if (SIGNATURE.some((byte, index) => png[index] !== byte)) throw new Error("An image frame does not hold a PNG");
  return new Blob([png], { type: "image/png" });
}

export const decodeImage = (message: ArrayBuffer): Promise<ImageBitmap> => createImageBitmap(pngOf(message));
