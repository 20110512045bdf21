/** False where the browser has no clipboard: without a secure origin, or forbidden. */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text);
  }
}

/** On plain http from another machine there is no navigator.clipboard; what it replaces still works in all browsers. */
function copyBySelection(text: string): boolean {
  const area = document.createElement("textarea");
  area.value = text;
  area.style.position = "fixed";
  document.body.append(area);
  const before = document.activeElement;
  area.select();
  const isCopied = (document as unknown as { execCommand(command: string): boolean }).execCommand("copy");
  area.remove();
  if (before instanceof HTMLElement) before.focus();
  return isCopied;
}
