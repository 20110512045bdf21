import { effect } from "@preact/signals";
import { beforeEach, describe, expect, test } from "vitest";
import { Histograms } from "../src/server/histograms";
import type { Histogram } from "../src/model/state";
import { RpcError } from "../src/server/rpc";
import { settled } from "./fake_socket";

interface Asked {
  array: string;
  answer: (histogram: Histogram) => void;
  refuse: (error: Error) => void;
}

const histogram: Histogram = { range: [0, 1], counts: [1], invalid: 0 };

let asked: Asked[] = [];
let waiting: { callback: () => void; milliseconds: number }[] = [];
let histograms: Histograms;
const arrays = (): string[] => asked.map(({ array }) => array);
const runLater = (): void => waiting.splice(0).forEach(({ callback }) => callback());

beforeEach(() => {
  [asked, waiting] = [[], []];
  histograms = new Histograms(
    (_dataset, array) => new Promise((answer, refuse) => asked.push({ array, answer, refuse })),
    (callback, milliseconds) => void waiting.push({ callback, milliseconds }),
  );
});

describe("histograms", () => {
  test("looking for one asks for nothing while the page is drawn", async () => {
    expect(histograms.get("d", "p", 0)).toBe(null);
    expect(histograms.get("d", "p", 0)).toBe(null);
    expect(asked).toEqual([]);
    expect(waiting.length).toBe(1);
    runLater();
    expect(arrays()).toEqual(["p"]);
    asked[0]?.answer(histogram);
    await settled();
    expect(histograms.get("d", "p", 0)).toBe(histogram);
    expect(waiting.length).toBe(0);
  });

  test("who has read one is run again when it arrives, and by no other", async () => {
    const seen: (Histogram | null)[] = [];
    const end = effect(() => void seen.push(histograms.get("d", "p", 0)));
    histograms.get("d", "q", 0);
    runLater();
    asked[1]?.answer({ ...histogram, counts: [2] });
    await settled();
    expect(seen).toEqual([null]);
    asked[0]?.answer(histogram);
    await settled();
    expect(seen).toEqual([null, histogram]);
    histograms.clear();
    expect(seen).toEqual([null, histogram, null]);
    end();
  });

  test("two at a time are asked for", async () => {
    for (const array of ["a", "b", "c", "d"]) histograms.get("d", array, 0);
    runLater();
    expect(arrays()).toEqual(["a", "b"]);
    asked[0]?.answer(histogram);
    await settled();
    expect(arrays()).toEqual(["a", "b", "c"]);
  });

  test("one that a limit has refused is asked for again, later", async () => {
    histograms.get("d", "p", 0);
    runLater();
    asked[0]?.refuse(new RpcError(-32003, "Limit exceeded", {}));
    await settled();
    expect(waiting.map(({ milliseconds }) => milliseconds)).toEqual([1000]);
    expect(asked.length).toBe(1);
    runLater();
    expect(arrays()).toEqual(["p", "p"]);
    asked[1]?.answer(histogram);
    await settled();
    expect(histograms.get("d", "p", 0)).toBe(histogram);
  });

  test("one that does not exist is not asked for again", async () => {
    histograms.get("d", "late", 0);
    runLater();
    asked[0]?.refuse(new RpcError(-32005, "Failed", {}));
    await settled();
    expect(histograms.get("d", "late", 0)).toBe(null);
    expect(waiting).toEqual([]);
  });

  test("an answer of before is not taken for one of after", async () => {
    histograms.get("d", "p", 0);
    runLater();
    histograms.clear();
    asked[0]?.answer(histogram);
    await settled();
    expect(histograms.get("d", "p", 0)).toBe(null);
    runLater();
    expect(arrays()).toEqual(["p", "p"]);
  });
});
