import { describe, expect, test } from "vitest";
import { askRefusal, offerToken, tokenIn, type Fetch } from "../src/server/access";

const BASE = "https://example.org/some/where/";

function answering(status: number, body: string, type: string, asked: [URL, RequestInit | undefined][] = []): Fetch {
  return (address, init) => {
    asked.push([address, init]);
    const response = new Response(status === 204 ? null : body, { status, headers: { "Content-Type": type } });
    Object.defineProperty(response, "url", { value: address.href });
    return Promise.resolve(response);
  };
}

describe("why no socket comes through", () => {
  test("asked by a call, below the page's own prefix", async () => {
    const asked: [URL, RequestInit | undefined][] = [];
    await askRefusal(BASE, answering(200, "{}", "application/json", asked));
    const [[address, init] = []] = asked;
    expect(address?.href).toBe("https://example.org/some/where/rpc");
    expect(init?.method).toBe("POST");
    expect(JSON.parse(init?.body as string)).toMatchObject({ jsonrpc: "2.0", method: "server.info" });
  });

  test.each([
    { status: 401, body: "no", type: "text/plain", refusal: { kind: "token" } },
    { status: 200, body: "{}", type: "application/json", refusal: { kind: "no-socket" } },
    {
      status: 403,
      body: "The origin is not this server's.\n",
      type: "text/plain; charset=utf-8",
      refusal: { kind: "refused", words: "The origin is not this server's." },
    },
    {
      status: 502,
      body: "<h1>Bad gateway</h1>",
      type: "text/html",
      refusal: { kind: "refused", words: "example.org is not a CIEL server; check the address. Its answer was 502" },
    },
  ])("$status means $refusal.kind", async ({ status, body, type, refusal }) => {
    expect(await askRefusal(BASE, answering(status, body, type))).toEqual(refusal);
  });

  test("nobody there is no refusal", async () => {
    expect(await askRefusal(BASE, () => Promise.reject(new TypeError("Failed to fetch")))).toBeNull();
  });
});

describe("the token", () => {
  test.each([
    ["secret-1", "secret-1"],
    ["  secret-1\n", "secret-1"],
    ["http://10.0.0.1:8080/?token=secret-1", "secret-1"],
    ["http://h/x/?a=b&token=secret-1#s=abc?token=no", "secret-1"],
    ["http://h/?a=b", "http://h/?a=b"],
    ["?token=%zz", "%zz"],
  ])("in %j is %j", (typed, token) => expect(tokenIn(typed)).toBe(token));

  test("is offered to the page's own address, and taken or not", async () => {
    const asked: [URL, RequestInit | undefined][] = [];
    expect(await offerToken(`${BASE}#s=abc`, "a&b", answering(200, "", "text/html", asked))).toBe(true);
    expect(asked[0]?.[0].href).toBe("https://example.org/some/where/?token=a%26b");
    expect(await offerToken(BASE, "x", answering(401, "", "text/plain"))).toBe(false);
    await expect(offerToken(BASE, "x", answering(403, "Not here.", "text/plain"))).rejects.toThrow("Not here.");
  });
});
