// Encodes and decodes a scene in an address, independently of the page's code: #s= and the deflated JSON as base64url.
import { deflateRawSync, inflateRawSync } from "node:zlib";

export const fragmentOf = (scene: unknown): string =>
  `#s=${deflateRawSync(JSON.stringify(scene)).toString("base64url")}`;

export const sceneOf = (address: string): unknown =>
  JSON.parse(inflateRawSync(Buffer.from(address.slice(address.indexOf("#s=") + 3), "base64url")).toString());
