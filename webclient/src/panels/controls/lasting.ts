import { useEffect, useState } from "preact/hooks";

/** Returns whether `holds` has been true for `milliseconds`. The time starts again when `since` changes. */
export function useLasting(holds: boolean, milliseconds: number, since: unknown = null): boolean {
  const [lasts, setLasts] = useState(false);
  useEffect(() => {
    setLasts(false);
    if (!holds) return;
    const timer = setTimeout(() => setLasts(true), milliseconds);
    return () => clearTimeout(timer);
  }, [holds, since]);
  return lasts && holds;
}
