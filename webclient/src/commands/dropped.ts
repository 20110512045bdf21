// Files dropped on the page. Data are read on the server's machine, so the page only explains how to open them.

const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;

/** Returns a sentence for the user who dropped a file of this name. */
export function answerToDrop(name: string): string {
  if (/\.ciel$/i.test(name))
    return `${name} is not opened from here: start the server with it, ciel serve ${name}, or put it into a folder that is served`;
  const stem = name.replace(/(?<=.)\.[^.]*$/, "");
  return `${name} is not opened from here. Import it where the server runs, ciel import ${name} -o ${stem}.ciel, and put that into a folder that is served`;
}

/** Prevents the browser from leaving the page to show the file. Returns a function that stops listening. */
export function listenToDrops(answer: (sentence: string) => void): () => void {
  const over = (event: DragEvent): void => {
    if (!isFile(event)) return;
    event.preventDefault();
    if (event.dataTransfer !== null) event.dataTransfer.dropEffect = "copy"; // "none" would suppress the drop
  };
  const drop = (event: DragEvent): void => {
    if (!isFile(event)) return;
    event.preventDefault();
    answer(answerToDrop(event.dataTransfer?.files[0]?.name ?? "The file"));
  };
  window.addEventListener("dragover", over);
  window.addEventListener("drop", drop);
  return () => {
    window.removeEventListener("dragover", over);
    window.removeEventListener("drop", drop);
  };
}
