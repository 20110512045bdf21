// Fragments of the page's address, which links contain: "#s=" and a scene (deflated JSON in base64url), or "#j=" and a
// session id.
import type { Scene } from "../generated/protocol";

const KEY = "s=";
const SESSION = /^#?j=([A-Za-z0-9_-]{22,64})$/;

export function toBase64Url(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const raw = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(raw, (character) => character.charCodeAt(0));
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  transform: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream as ReadableStream<Uint8Array<ArrayBuffer>>).arrayBuffer());
}

export async function encodeScene(scene: Scene): Promise<string> {
  const json = new TextEncoder().encode(JSON.stringify(scene));
  return `#${KEY}${toBase64Url(await through(json, new CompressionStream("deflate-raw")))}`;
}

/** Returns the scene in the fragment; null if there is none. Throws Error if the scene's text is damaged. */
export async function decodeScene(fragment: string): Promise<Scene | null> {
  const start = fragment.replace(/^#/, "");
  if (!start.startsWith(KEY)) return null;
  try {
    const json = await through(fromBase64(start.slice(KEY.length)), new DecompressionStream("deflate-raw"));
    const scene = JSON.parse(new TextDecoder().decode(json)) as unknown;
    if (typeof scene === "object" && scene !== null && typeof (scene as Scene).dataset === "string")
      return scene as Scene;
  } catch {
    // The error below also reports this failure.
  }
  throw new Error("The link does not hold a whole scene. Part of the link may have been lost; copy the link again");
}

/** Returns a session's id as a fragment with leading "#". Anyone who has the id may change the session's scene. */
export const encodeSession = (id: string): string => `#j=${id}`;

export const decodeSession = (fragment: string): string | null => SESSION.exec(fragment)?.[1] ?? null;
