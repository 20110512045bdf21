// Messages to and from the WebAssembly module (server/page/message.hpp). A message is a sequence of 64-bit floats. A
// text is its number of bytes, and then its UTF-8 bytes, padded with zeros to whole floats.

const FLOAT_BYTES = 8;
const encoder = new TextEncoder();
const decoder = new TextDecoder();

export type Item = number | boolean | string | readonly Item[];

/** Arrays are written without their length. */
function append(message: number[], item: Item): void {
  if (typeof item === "number") message.push(item);
  else if (typeof item === "boolean") message.push(item ? 1 : 0);
  else if (typeof item === "string") message.push(...textFloats(item));
  else for (const each of item) append(message, each);
}

function textFloats(text: string): number[] {
  const bytes = encoder.encode(text);
  const padded = new Uint8Array(Math.ceil(bytes.length / FLOAT_BYTES) * FLOAT_BYTES);
  padded.set(bytes);
  return [bytes.length, ...new Float64Array(padded.buffer)];
}

export function messageOf(items: readonly Item[]): number[] {
  const message: number[] = [];
  append(message, items);
  return message;
}

export class ResultReader {
  private at = 0;

  constructor(private readonly message: Float64Array) {}

  number(): number {
    const value = this.message[this.at];
    if (value === undefined) throw new Error("The layout module returned too few numbers. Reload the page");
    this.at += 1;
    return value;
  }

  text(): string {
    const length = this.number();
    const bytes = new Uint8Array(this.message.buffer, this.message.byteOffset + FLOAT_BYTES * this.at, length);
    this.at += Math.ceil(length / FLOAT_BYTES);
    return decoder.decode(bytes);
  }

  list<T>(read: () => T): T[] {
    return Array.from({ length: this.number() }, read);
  }
}
