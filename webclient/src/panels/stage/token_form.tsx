// Form for the token that the server asks for.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { useCommands } from "../context";

export function TokenForm(): JSX.Element {
  const commands = useCommands();
  const [typed, setTyped] = useState("");
  const [problem, setProblem] = useState<string | null>(null);
  const [asking, setAsking] = useState(false);
  const enter = async (event: Event): Promise<void> => {
    event.preventDefault();
    setAsking(true);
    setProblem(await commands.enterToken(typed));
    setAsking(false);
  };
  return (
    <form class="notice" aria-label="Token" onSubmit={(event) => void enter(event)}>
      <strong role="alert">This server asks for its token</strong>
      <p>
        Open the address that <code>ciel serve</code> printed when it started; it ends in <code>?token=</code> and the
        token. Or give the token, or that whole address, here:
      </p>
      <div class="token-row">
        <input
          class="text-field"
          type="text"
          aria-label="Token"
          aria-invalid={problem !== null}
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          value={typed}
          onInput={(event) => {
            setTyped(event.currentTarget.value);
            setProblem(null);
          }}
        />
        <button type="submit" class="button primary" disabled={asking || typed.trim() === ""}>
          Enter
        </button>
      </div>
      {problem !== null && <p class="problem">{problem}</p>}
    </form>
  );
}
