/** Is the server there? Says so when it is gone, and goes on when it is back. */

import * as api from "../api";
import { el, sleep } from "../dom";
import type { Store } from "../store";
import { say } from "./dialogs";

const TEXTS = {
  up: "",
  down: "The server does not answer. What you do here is kept; it goes on as soon as `frond studio` runs again on this address.",
  refused: "This page is not known to the server. Open the address that `frond studio` printed, here or in another tab: what you did is kept, and goes on.",
};

/** What is not saved can be had as a file, whatever becomes of the server. */
function download(store: Store): HTMLElement {
  const give = (): void => {
    const address = URL.createObjectURL(new Blob([store.text], { type: "application/json" }));
    el<HTMLAnchorElement>("a", { href: address, download: store.name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  };
  return el("button.small", { type: "button", "data-testid": "download", click: give }, "Download the preset");
}

export function linkBanner(store: Store, back: () => void): HTMLElement {
  const banner = el("div.banner", { role: "alert", hidden: true, "data-testid": "banner" });
  let started = "";
  store.on("link", () => {
    banner.replaceChildren(TEXTS[store.link], ...(store.unsaved ? [download(store)] : []));
    banner.hidden = store.link === "up";
  });

  const check = async (): Promise<void> => {
    try {
      const answer = await api.ping();
      const restarted = started !== "" && started !== answer.started;
      const wasAway = store.link !== "up";
      started = answer.started;
      store.setLink("up");
      if (restarted || wasAway) api.tellToken();
      if (restarted) say("The server was started anew. Everything is still here.");
      if (restarted || wasAway) back();
    } catch (error) {
      store.setLink(error instanceof api.ApiError && error.status === 403 ? "refused" : "down");
    }
  };
  void (async () => {
    for (;;) {
      await check();
      await sleep(store.link === "up" ? 3000 : 1000);
    }
  })();
  return banner;
}
