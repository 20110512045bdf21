// The address of a scene, written and read here without the client's help: #s= and the deflated JSON as base64url.
import { deflateRawSync, inflateRawSync } from "node:zlib";

export const fragmentOf = (scene: unknown): string =>
  `#s=${deflateRawSync(JSON.stringify(scene)).toString("base64url")}`;

export const sceneOf = (address: string): unknown =>
  JSON.parse(inflateRawSync(Buffer.from(address.slice(address.indexOf("#s=") + 3), "base64url")).toString());
