import { beforeEach, describe, expect, test } from "vitest";
import { GeometryDecoder, type GeometryBatch } from "../src/server/geometry";
import { Presenter } from "../src/view/presenter";
import { frameBytes, geometryPayload, PNG_SIGNATURE } from "./frames";
import { settled } from "./fake_socket";
import { linePayload } from "./geometry_frames";

interface FakeImage {
  frame: number;
  closed: boolean;
}

let acknowledged: number[] = [];
let drawn: (number | GeometryBatch[])[] = [];
let failures: Error[] = [];
let arrived: number[] = [];
let incomplete = 0;
let frames: (() => void)[] = [];
let decoding = new Map<number, { finish: () => void; fail: (error: Error) => void; image: FakeImage }>();
let presenter: Presenter;
let canDraw = true;

const runFrame = (): void => frames.splice(0).forEach((frame) => frame());
const image = (frame: number, view = 1): void => presenter.receive(frameBytes({ frame, view }, PNG_SIGNATURE));
const finish = async (frame: number): Promise<void> => {
  decoding.get(frame)?.finish();
  await settled();
};

beforeEach(() => {
  canDraw = true;
  [acknowledged, drawn, failures, frames, decoding] = [[], [], [], [], new Map<number, never>()];
  incomplete = 0;
  presenter = new Presenter(
    {
      showImage: (bitmap) => void drawn.push((bitmap as unknown as FakeImage).frame),
      showGeometry: (batches) => {
        if (!canDraw) throw new Error("no WebGL2");
        drawn.push(batches);
      },
    },
    {
      image: (message) =>
        new Promise((resolve, reject) => {
          const frame = new DataView(message).getUint32(12, true);
          const bitmap = { frame, closed: false, close: () => void (bitmap.closed = true) };
          decoding.set(frame, {
            finish: () => resolve(bitmap as unknown as ImageBitmap),
            fail: reject,
            image: bitmap,
          });
        }),
      geometry: new GeometryDecoder(),
    },
    {
      arrived: ({ frame }) => void arrived.push(frame),
      acknowledge: (_, frame) => void acknowledged.push(frame),
      presented: () => undefined,
      failed: (error) => void failures.push(error),
      incomplete: () => {
        incomplete += 1;
      },
    },
    (callback) => void frames.push(callback),
  );
  presenter.show(1);
});

describe("images", () => {
  test("acknowledged when drawn, not when received or decoded", async () => {
    image(1);
    await finish(1);
    expect(acknowledged).toEqual([]);
    runFrame();
    expect(drawn).toEqual([1]);
    expect(acknowledged).toEqual([1]);
    expect(decoding.get(1)?.image.closed).toBe(true);
    image(1); // the same frame a second time
    await finish(1);
    runFrame();
    runFrame();
    expect(drawn).toEqual([1]);
    image(2);
    await finish(2);
    runFrame();
    runFrame();
    expect(drawn).toEqual([1, 2]);
    expect(acknowledged).toEqual([1, 1, 2]);
  });

  test("acknowledged if a piece is missing, so that the server sends the next one", () => {
    const rest = frameBytes({ frame: 5, view: 1, offset: 8, whole: 8 + PNG_SIGNATURE.length }, PNG_SIGNATURE);
    presenter.receive(rest);
    expect(failures.map(({ message }) => message)).toEqual(["A piece of frame 5 is missing. Reload the page"]);
    expect(acknowledged).toEqual([5]);
  });

  test("only the newest of two is drawn, both are acknowledged", async () => {
    image(1);
    image(2);
    await finish(1);
    await finish(2);
    runFrame();
    expect(drawn).toEqual([2]);
    expect(acknowledged.sort()).toEqual([1, 2]);
    expect(decoding.get(1)?.image.closed).toBe(true);
  });

  test("one that is decoded after a newer one was drawn is never seen", async () => {
    image(1);
    image(2);
    await finish(2);
    runFrame();
    await finish(1);
    runFrame();
    expect(drawn).toEqual([2]);
    expect(acknowledged.sort()).toEqual([1, 2]);
  });

  test("another view's frames are not this one's", async () => {
    image(1, 5);
    image(2);
    presenter.show(6);
    await finish(2);
    runFrame();
    expect(drawn).toEqual([]);
    expect(acknowledged).toEqual([]);
  });

  test("one that cannot be decoded is said, and does not stop the stream", async () => {
    image(1);
    decoding.get(1)?.fail(new Error("damaged"));
    await settled();
    expect(failures.length).toBe(1);
    expect(acknowledged).toEqual([1]);
    presenter.receive(new ArrayBuffer(3));
    presenter.receive(frameBytes({ kind: 9 }, PNG_SIGNATURE));
    expect(failures.length).toBe(3);
  });
});

const part = linePayload;

describe("while a view is being opened", () => {
  test("its messages are told when they come, not when they are taken", () => {
    presenter.expect();
    arrived = [];
    presenter.receive(frameBytes({ kind: 2, flags: 4, view: 8, frame: 1 }, part("a")));
    expect(arrived).toEqual([1]);
    presenter.show(8);
    expect(arrived).toEqual([1]);
  });

  test("its polygons are kept, whichever message comes first", () => {
    presenter.expect();
    presenter.receive(frameBytes({ kind: 2, flags: 4, view: 8, frame: 1 }, part("a")));
    presenter.receive(frameBytes({ kind: 2, flags: 2, view: 8, frame: 1 }, part("b")));
    runFrame();
    expect([drawn, acknowledged]).toEqual([[], []]);
    presenter.show(8);
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "a" }, { layer: "b" }]]);
    expect(acknowledged).toEqual([1]);
  });

  test("a frame that is half here is made whole after the answer", () => {
    presenter.expect();
    presenter.receive(frameBytes({ kind: 2, flags: 4, view: 8, frame: 1 }, part("a")));
    presenter.show(8);
    presenter.receive(frameBytes({ kind: 2, flags: 2, view: 8, frame: 1 }, part("b")));
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "a" }, { layer: "b" }]]);
  });

  test("of two pictures the newest is shown, both are acknowledged", async () => {
    presenter.expect();
    image(1, 8);
    image(2, 8);
    presenter.show(8);
    await finish(1);
    await finish(2);
    runFrame();
    expect(drawn).toEqual([2]);
    expect(acknowledged.sort()).toEqual([1, 2]);
  });

  test("frames of another view are not shown, nor those of a view that is not opened after all", () => {
    presenter.expect();
    presenter.receive(frameBytes({ kind: 2, flags: 6, view: 1, frame: 7 }, part("old")));
    presenter.receive(frameBytes({ kind: 2, flags: 6, view: 8, frame: 1 }, part("new")));
    presenter.show(8);
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "new" }]]);
    presenter.expect();
    presenter.receive(frameBytes({ kind: 2, flags: 6, view: 9, frame: 1 }, part("never")));
    presenter.show(0);
    presenter.show(9);
    runFrame();
    expect(drawn.length).toBe(1);
    expect(acknowledged).toEqual([1]);
  });

  test("no more is kept than a server sends unacknowledged", () => {
    presenter.expect();
    for (const frame of [1, 2, 3, 4]) image(frame, 8);
    presenter.show(8);
    expect([...decoding.keys()]).toEqual([3, 4]);
  });
});

describe("geometry", () => {
  test("a frame with a damaged batch is said and acknowledged, not shown, and the next one is", () => {
    presenter.receive(frameBytes({ kind: 2, flags: 4, frame: 3 }, part("a").slice(0, 20)));
    presenter.receive(frameBytes({ kind: 2, flags: 2, frame: 3 }, part("b")));
    runFrame();
    expect([failures.length, drawn, acknowledged]).toEqual([1, [], [3]]);
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 4 }, part("c")));
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "c" }]]);
    expect(acknowledged).toEqual([3, 4]);
  });

  test("polygons that came before are drawn again, and asked for where they were lost", () => {
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 3 }, part("a")));
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 4 }, part("b", true)));
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "b", positions: Float32Array.of(0, 0, 0, 1, 0, 0) }]]);
    expect(incomplete).toBe(0);
    presenter.show(1);
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 1 }, part("c", true)));
    expect([incomplete, failures.length]).toEqual([1, 1]);
  });

  test("where it cannot be drawn, that is said, and the server goes on", () => {
    canDraw = false;
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 3 }, part("a")));
    runFrame();
    expect([failures.length, acknowledged]).toEqual([1, [3]]);
  });

  test("a frame is shown when its last message is here, and acknowledged once", () => {
    presenter.receive(frameBytes({ kind: 2, flags: 4, frame: 3 }, part("a")));
    runFrame();
    expect(drawn).toEqual([]);
    presenter.receive(frameBytes({ kind: 2, flags: 2, frame: 3 }, part("b")));
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "a" }, { layer: "b" }]]);
    expect(acknowledged).toEqual([3]);
  });

  test("a new frame does not take over an unfinished one's parts", () => {
    presenter.receive(frameBytes({ kind: 2, flags: 4, frame: 3 }, part("old")));
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 4 }, part("new")));
    runFrame();
    expect(drawn).toMatchObject([[{ layer: "new" }]]);
  });

  test("a frame without polygons clears the view", () => {
    presenter.receive(frameBytes({ kind: 2, flags: 6, frame: 1 }, geometryPayload({ batches: 0, base: 0 }, [])));
    runFrame();
    expect(drawn).toEqual([[]]);
  });
});
