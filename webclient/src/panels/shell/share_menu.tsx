// Menu that copies links: to a copy of the current scene, or to this session, in which all users change one scene.
import type { JSX } from "preact";
import { Menu } from "../controls/controls";
import { useCommands } from "../context";

export function ShareMenu({ disabled }: { disabled: boolean }): JSX.Element {
  const commands = useCommands();
  return (
    <Menu icon="link" label="Share" disabled={disabled}>
      {(close) => (
        <>
          <button
            type="button"
            class="button"
            title="A copy of the scene as it is now (L)"
            onClick={() => {
              close();
              void commands.files.copyLink();
            }}
          >
            Copy a link to this view
          </button>
          <button
            type="button"
            class="button"
            title="Whoever opens it sees what you see, and can change it"
            onClick={() => {
              close();
              void commands.files.copySessionLink();
            }}
          >
            Copy a link to this session
          </button>
        </>
      )}
    </Menu>
  );
}
