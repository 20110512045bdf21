// A file that is dropped on the page. The page cannot open it, for data are read where the server runs; it says how.

const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;

/** A sentence for a person who dropped a file of that name. */
export function answerToDrop(name: string): string {
  if (/\.ciel$/i.test(name))
    return `${name} is not opened from here: start the server with it, ciel serve ${name}, or put it into a folder that is served`;
  const stem = name.replace(/(?<=.)\.[^.]*$/, "");
  return `${name} is not opened from here. Import it where the server runs, ciel import ${name} -o ${stem}.ciel, and put that into a folder that is served`;
}

/** Without this the browser would leave the page to show the file. */
export function listenToDrops(answer: (sentence: string) => void): () => void {
  const over = (event: DragEvent): void => {
    if (!isFile(event)) return;
    event.preventDefault();
    if (event.dataTransfer !== null) event.dataTransfer.dropEffect = "copy"; // "none" would bring no drop
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
