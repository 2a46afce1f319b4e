/** Offers what a tab that is gone had not saved. */

import { forget, leftByOthers } from "../drafts";
import type { Store } from "../store";
import { ask } from "./dialogs";

export async function offerLeft(store: Store): Promise<void> {
  for (const left of await leftByOthers()) {
    const name = left.draft.file.split("/").at(-1)!;
    const when = new Date(left.when).toLocaleString("en-GB", { dateStyle: "medium", timeStyle: "short" });
    const answer = await ask("Not saved", `What was changed in ${name} until ${when}, in a tab that is gone, was not saved.`,
      [{ value: "later", label: "Later" }, { value: "forget", label: "Throw it away" }, { value: "go-on", label: "Go on with it", primary: true }], "left");
    if (answer === "forget") forget(left);
    if (answer !== "go-on") continue;
    store.restore(left.draft);
    forget(left);
    return;
  }
}
