// @vitest-environment happy-dom
import { describe, expect, test, vi } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { Busy, ConnectionNotice, FatalNotice, LackingNotice, ToastList } from "../../src/panels/stage/notice";
import { TokenForm } from "../../src/panels/stage/token_form";
import { settled } from "../fake_socket";
import { stand } from "./stand";

const scene: Scene = { dataset: "box", layers: { iso: { type: "iso", array: "p", values: [2] } } };
const datasets = [
  { name: "box", problem: "" },
  { name: "ball", problem: "" },
] as never;

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
