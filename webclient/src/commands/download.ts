// Saves base64 data as a file on the user's machine.
import { fromBase64 } from "../model/link";

export function download(name: string, mime: string, base64: string): void {
  const address = URL.createObjectURL(new Blob([fromBase64(base64)], { type: mime }));
  const anchor = document.createElement("a");
  anchor.href = address;
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
