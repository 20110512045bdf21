// Tells the user how to open a file that was dropped on the page. The page cannot open the file: the server reads
// only files on the machine where it runs.

const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;

export function answerToDrop(name: string): string {
  if (/\.ciel$/i.test(name))
    return `${name} cannot be opened in the page. Start the server with the dataset, ciel serve ${name}, or put the dataset into a folder that is served`;
  const stem = name.replace(/(?<=.)\.[^.]*$/, "");
  return `${name} cannot be opened in the page. Import the file where the server runs, ciel import ${name} -o ${stem}.ciel, and put the dataset into a folder that is served`;
}

/** Calls `answer` when a file is dropped. Returns a function that stops listening. */
export function listenToDrops(answer: (sentence: string) => void): () => void {
  const over = (event: DragEvent): void => {
    if (!isFile(event)) return;
    event.preventDefault();
    if (event.dataTransfer !== null) event.dataTransfer.dropEffect = "copy"; // with "none", no drop event is sent
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
