// Decodes messages of the image stream (kind 1 of protocol/frame.md). A message contains one picture. The browser
// decodes the picture outside the main thread.
import { FRAME_HEADER_BYTES } from "../generated/frame_header";

const SIGNATURES: Record<string, number[]> = {
  "image/png": [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a],
  "image/jpeg": [0xff, 0xd8, 0xff],
};

/** Throws Error for a payload that is neither PNG nor JPEG. */
export function pictureOf(message: ArrayBuffer): Blob {
  const picture = new Uint8Array(message, FRAME_HEADER_BYTES);
  for (const [type, signature] of Object.entries(SIGNATURES))
    if (signature.every((byte, index) => picture[index] === byte)) return new Blob([picture], { type });
  throw new Error("An image frame contains neither a PNG nor a JPEG. Reload the page");
}

export const decodeImage = (message: ArrayBuffer): Promise<ImageBitmap> => createImageBitmap(pictureOf(message));
