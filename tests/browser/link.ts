// The address of a scene, written here without the client's help: #s= and the deflated JSON as base64url.
import { deflateRawSync } from "node:zlib";

export const fragmentOf = (scene: unknown): string =>
  `#s=${deflateRawSync(JSON.stringify(scene)).toString("base64url")}`;
