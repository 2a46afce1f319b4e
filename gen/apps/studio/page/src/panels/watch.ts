/** Notices when somebody else writes the file that is open, and offers to load it. */

import * as api from "../api";
import { el, sleep } from "../dom";
import type { Store } from "../store";
import { say } from "./dialogs";
import { isSaving, loadTheirs } from "./saving";

const EVERY = 2500; // milliseconds

/** What stands for the file on the disk, where another program has written it. */
async function changed(store: Store): Promise<string | null> {
  if (!store.isOpen || store.copy || !store.disk || store.link !== "up" || document.hidden || isSaving()) return null;
  const { file, disk } = store;
  const now = await api.disk(file).catch(() => "");
  return now && now !== disk && store.file === file && store.disk === disk && !isSaving() ? now : null;
}

/** A line above the workshop that says so; nobody is interrupted by it. */
export function watchFile(store: Store): HTMLElement {
  const banner = el("div.banner", { role: "status", hidden: true, "data-testid": "changed" });
  const hide = (): void => void (banner.hidden = true);
  const load = (): void => {
    hide();
    loadTheirs(store, store.file).catch((error: unknown) => say((error as Error).message, true));
  };
  let told = "";
  store.on(["opened", "saved"], hide);
  void (async () => {
    for (;;) {
      await sleep(EVERY);
      const now = await changed(store);
      if (!now || now === told) continue;
      told = now;
      banner.replaceChildren(`Another program has written ${store.name}.${store.unsaved ? " What you changed here is not in it." : ""}`,
        el("button.small", { type: "button", "data-testid": "answer:load", click: load }, "Load theirs"),
        el("button.small", { type: "button", "data-testid": "answer:keep", click: hide }, "Keep what is here"));
      banner.hidden = false;
    }
  })();
  return banner;
}
