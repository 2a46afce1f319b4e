/** Saving: under the file's name, or another. */

import * as api from "../api";
import { el } from "../dom";
import type { Store } from "../store";
import { ask, buttons, dialog, say } from "./dialogs";

export async function save(store: Store): Promise<void> {
  if (!store.isOpen) return;
  if (store.copy) return saveAs(store);
  await write(store, store.file, store.disk, false, false);
}

export async function saveAs(store: Store, suggestion = suggested(store)): Promise<void> {
  const name = el<HTMLInputElement>("input.text", { type: "text", "aria-label": "Name of the file", value: suggestion, "data-testid": "save-name", autofocus: true });
  const answer = await dialog("Save as", (close) => {
    name.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || event.repeat) return;
      event.preventDefault();
      close("save");
    });
    return [
      el("label.field", {}, el("span", {}, "File"), name),
      buttons([{ value: "cancel", label: "Cancel" }, { value: "save", label: "Save", primary: true }], close),
    ];
  }, "save-as");
  const file = name.value.trim();
  if (answer !== "save" || !file) return;
  await write(store, /\.json$/.test(file) ? file : `${file}.json`, null, false, false);
}

/** A copy goes to the folder of the studio's own preset; what it names goes along. What is new has no other that it is a copy of. */
export function suggested(store: Pick<Store, "copy" | "disk" | "file">): string {
  return store.copy && store.disk !== null ? store.file.replace(/^.*\//, "").replace(/(\.json)?$/, "_copy.json") : store.file;
}

let saving = 0;
/** Whether a file is being written: what is on the disk may be newer than what is known of it. */
export const isSaving = (): boolean => saving > 0;

async function write(store: Store, file: string, disk: string | null, overwrite: boolean, force: boolean): Promise<void> {
  const { doc } = store;
  let answer: api.SaveAnswer;
  saving++;
  try {
    answer = await api.save(file, doc, disk, overwrite, force);
    if (answer.is === "saved") keep(store, doc, answer);
  } catch (error) {
    say(`Not saved: ${(error as Error).message}`, true);
    // Where a folder may not be written in, a plain name stands for the one that may.
    if (error instanceof api.ApiError && error.status === 403 && file.includes("/")) await saveAs(store, file.split("/").at(-1)!);
    return;
  } finally {
    saving--;
  }
  if (answer.is === "saved") return say(`Saved ${answer.file}`);
  if (answer.is === "wrong") {
    const first = answer.errors[0];
    const chosen = await ask("This is no preset yet", `${first?.text ?? "Something is wrong"}${first?.line ? `, line ${first.line}` : ""}. Save the text as it is?`,
      [{ value: "cancel", label: "Go on editing" }, { value: "force", label: "Save it nevertheless", primary: true }], "save-wrong");
    if (chosen === "force") await write(store, file, disk, overwrite, true);
    return;
  }
  const changed = answer.error === "changed on disk";
  const chosen = await ask(changed ? "The file has changed on disk" : "There is such a file", changed
    ? `${file} is not what was opened here: somebody else has written it since. Overwriting takes their changes away.`
    : `${file} is there already.`,
    [{ value: "cancel", label: "Cancel" }, ...(changed ? [{ value: "load", label: "Load theirs" }] : []), { value: "overwrite", label: "Overwrite" }, { value: "other", label: "Another name", primary: true }], "save-conflict");
  if (chosen === "overwrite") await write(store, file, answer.disk, true, force);
  if (chosen === "other") await saveAs(store);
  if (chosen === "load") await loadTheirs(store, file);
}

function keep(store: Store, doc: api.Doc, answer: { file: string; disk: string; text: string }): void {
  if (answer.text !== doc.text && store.text === doc.text) store.change(answer.text);
  store.markSaved(answer.file, answer.disk, answer.text);
}

/** What is on disk becomes the text; undo brings one's own back. */
export async function loadTheirs(store: Store, file: string): Promise<void> {
  const theirs = await api.preset(file);
  store.change(theirs.text);
  store.markSaved(theirs.file, theirs.disk ?? "", theirs.text);
}
