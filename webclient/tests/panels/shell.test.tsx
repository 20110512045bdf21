// @vitest-environment happy-dom
import { describe, expect, test, vi } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { Busy, ConnectionNotice, FatalNotice, LackingNotice, ToastList } from "../../src/panels/shell/notice";
import { PictureMenu } from "../../src/panels/shell/picture_menu";
import { ShareMenu } from "../../src/panels/shell/share_menu";
import { StatusBar } from "../../src/panels/shell/status_bar";
import { TokenForm } from "../../src/panels/shell/token_form";
import { Toolbar } from "../../src/panels/shell/toolbar";
import { emptyReadout } from "../../src/model/state";
import { settled } from "../fake_socket";
import { stand } from "./stand";

const scene: Scene = { dataset: "box", layers: { iso: { type: "iso", array: "p", values: [2] } } };
const datasets = [
  { name: "box", problem: "" },
  { name: "ball", problem: "" },
] as never;

describe("the toolbar", () => {
  test("opens a dataset and looks along an axis", () => {
    const { calls, choose, click } = stand(<Toolbar />, scene, { datasets });
    choose("Dataset", "ball");
    click("Show what is drawn");
    click("Look from minus y");
    expect(calls).toEqual([["openDataset", "ball"], ["camera.reset"], ["camera.lookFrom", "-y"]]);
  });

  test("saves a picture, exports a surface, and changes the theme", () => {
    const { calls, click } = stand(<Toolbar />, scene, { datasets, theme: "light" });
    click("Save a picture");
    click("Export a surface");
    click("Triangles only");
    click("STL");
    click("Theme: light");
    click("Side panel");
    expect(calls).toEqual([
      ["files.screenshot"],
      ["files.exportSurface", "iso", "stl", true],
      ["page.setTheme", "dark"],
      ["page.togglePanel"],
    ]);
  });
});

describe("the menu of pictures", () => {
  test("saves the size of the view, a typed size or a usual one, and closes", () => {
    const { calls, click, root, type } = stand(<PictureMenu disabled={false} />, scene);
    const save = (choose: () => void): void => {
      click("Pictures of other sizes");
      choose();
      click("Save");
      expect(root.querySelector(".menu-body")).toBeNull();
    };
    save(() => undefined);
    save(() => type("Width of the picture in pixels", "1000"));
    save(() => click("4K"));
    save(() => click("1 times as large as the view"));
    expect(calls).toEqual(
      [
        [800, 600],
        [1000, 600],
        [3840, 2160],
        [800, 600],
      ].map(([width, height]) => ["files.screenshot", { width, height }]),
    );
  });

  test("tells the limits of a size", () => {
    const { calls, click, type } = stand(<PictureMenu disabled={false} />, scene);
    click("Pictures of other sizes");
    type("Height of the picture in pixels", "3");
    expect(calls).toEqual([["tell", expect.stringContaining("from 16 to 8192")]]);
  });

  test("closes by Escape and by a press beside it", () => {
    const { change, click, key, root } = stand(<PictureMenu disabled={false} />, scene);
    click("Pictures of other sizes");
    key("Save", "Escape");
    expect(root.querySelector(".menu-body")).toBeNull();
    click("Pictures of other sizes");
    change(() => void document.body.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true })));
    expect(root.querySelector(".menu-body")).toBeNull();
  });
});

test("links are copied, and the menu closes", () => {
  const { calls, click, root } = stand(<ShareMenu disabled={false} />, scene);
  click("Share");
  click("Copy a link to this view");
  expect(root.querySelector(".menu-body")).toBeNull();
  click("Share");
  click("Copy a link to this session");
  expect(calls).toEqual([["files.copyLink"], ["files.copySessionLink"]]);
});

test("a token is entered, and the reason of a refusal stays until it is typed again", async () => {
  const refused = { enterToken: Promise.resolve("This is not the token.") };
  const { calls, change, find, root, type } = stand(<TokenForm />, scene, {}, refused);
  expect((find("Enter") as HTMLButtonElement).disabled).toBe(true);
  type("Token", "abc");
  change(
    () => void root.querySelector("form")?.dispatchEvent(new Event("submit", { bubbles: true, cancelable: true })),
  );
  await settled();
  change(() => undefined);
  expect(calls).toEqual([["enterToken", "abc"]]);
  expect(root.querySelector(".problem")?.textContent).toBe("This is not the token.");
  type("Token", "abcd");
  expect(root.querySelector(".problem")).toBeNull();
});

describe("notices", () => {
  test("of a lost connection try again by their button", () => {
    vi.useFakeTimers();
    const retryAt = Date.now() + 3000;
    const { calls, click, root } = stand(<ConnectionNotice />, scene, {
      connection: { kind: "waiting", attempt: 2, retryAt },
    });
    expect(root.textContent).toContain("Next try in 3 s.");
    click("Try now");
    expect(calls).toEqual([["retry"]]);
    vi.useRealTimers();
  });

  test("of a needed token show the form for it", () => {
    const { find } = stand(<ConnectionNotice />, scene, {
      connection: { kind: "waiting", attempt: 2, retryAt: 0 },
      refusal: { kind: "token" },
    });
    expect(find("Token").tagName).toBe("INPUT");
  });

  test("of a scene that cannot be shown offer other datasets and another try", () => {
    const { calls, click, root } = stand(<FatalNotice />, scene, { fatal: "The file is gone.", datasets });
    expect(root.textContent).toContain("The file is gone.");
    click("ball");
    click("Try again");
    expect(calls).toEqual([["openDataset", "ball"], ["reopen"]]);
  });

  test("of a scene that cannot be shown tell that another try lasts, and offer the next when it has failed", async () => {
    let fail = (): void => undefined;
    const reopen = new Promise<void>((resolve) => (fail = resolve));
    const { change, click, find } = stand(<FatalNotice />, scene, { fatal: "The file is gone.", datasets }, { reopen });
    click("Try again");
    expect((find("Trying again…") as HTMLButtonElement).disabled).toBe(true);
    fail();
    await settled();
    change(() => undefined);
    expect((find("Try again") as HTMLButtonElement).disabled).toBe(false);
  });

  test("of a long call cancel the call", () => {
    const { calls, click, root } = stand(<Busy />, scene, {
      longCall: { words: "Drawing the picture", name: "1", progress: null },
    });
    expect(root.textContent).toContain("Drawing the picture");
    click("Cancel");
    expect(calls).toEqual([["files.cancel"]]);
  });

  test("of empty layers stand while no layer shows anything", () => {
    const empty = [{ layer: "iso", why: "outside" as const, reason: "No value of p is 2." }];
    const { change, model, root } = stand(<LackingNotice />, scene, { empty });
    expect(root.textContent).toContain("No value of p is 2.");
    change(() => void (model.empty.value = []));
    expect(root.textContent).toBe("");
  });

  test("are dismissed one by one", () => {
    const { calls, click, root } = stand(<ToastList />, scene, { toasts: [{ id: 7, kind: "error", text: "Lost" }] });
    expect(root.querySelector("[role=alert]")?.textContent).toContain("Lost");
    click("Close the message");
    expect(calls).toEqual([["dismiss", 7]]);
  });
});

test("the status bar tells the picture that is shown", () => {
  const readout = {
    ...emptyReadout,
    stream: "image" as const,
    still: true,
    framesPerSecond: 12,
    latencyMs: 8,
    triangles: 3,
  };
  const { change, model, root } = stand(<StatusBar />, scene, { readout, shownScene: scene });
  for (const words of ["1 cells", "image, still", "3 triangles", "latency 8.0 ms", "12 fps"])
    expect(root.textContent).toContain(words);
  change(() => void (model.readout.value = { ...readout, stream: "geometry" }));
  expect(root.querySelector("[data-readout=stream]")?.textContent).toBe("geometry");
});
