/** Is the server there? Says so when it is gone, and goes on when it is back. */

import * as api from "../api";
import { el, sleep } from "../dom";
import type { Store } from "../store";
import { say } from "./dialogs";

const TEXTS = {
  up: "",
  down: "The server does not answer. What you do here is kept; it goes on as soon as `frond studio` runs again on this address.",
  refused: "This page is not known to the server. Open the address that `frond studio` printed; what you did here stays in this tab.",
};

export function linkBanner(store: Store, back: () => void): HTMLElement {
  const banner = el("div.banner", { role: "alert", hidden: true, "data-testid": "banner" });
  let started = "";
  store.on("link", () => {
    banner.textContent = TEXTS[store.link];
    banner.hidden = store.link === "up";
  });

  const check = async (): Promise<void> => {
    try {
      const answer = await api.ping();
      const restarted = started !== "" && started !== answer.started;
      const wasAway = store.link !== "up";
      started = answer.started;
      store.setLink("up");
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
