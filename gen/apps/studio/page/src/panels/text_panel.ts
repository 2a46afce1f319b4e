/** The preset as text. */

import { codeArea } from "../controls/code_area";
import { el, quiet } from "../dom";
import { placeOf } from "../edits";
import type { Path } from "../pointer";
import type { Store } from "../store";

export function textPanel(store: Store): { element: HTMLElement; opened(): void; closed(): void; goTo(line: number, column?: number): void; goToPath(path: Path): void } {
  const take = quiet(200, () => store.change(area.box.value, "text"));
  // A pause in typing ends what undo takes back at once.
  const pause = quiet(1200, () => store.endGesture());
  const area = codeArea("The preset as text", () => (take(), pause()), { "data-testid": "text" });
  area.box.addEventListener("keydown", (event) => (event.ctrlKey || event.metaKey) && take.now());
  area.box.addEventListener("blur", () => {
    take.now();
    store.endGesture();
  });
  let open = false;
  const refresh = (): void => {
    if (!open) return;
    if (document.activeElement !== area.box) area.show(store.text);
    const lines = new Map(store.faults.filter((f) => f.line > 0).map((f) => [f.line, f.text]));
    area.mark(lines);
  };
  // What undo brings back is shown also while the person is in the box.
  store.on("text", () => {
    if (document.activeElement === area.box && area.box.value !== store.text) area.show(store.text);
    refresh();
  });
  store.on(["opened", "scene"], refresh);
  return {
    element: el("div.text-panel", {}, area.element),
    opened(): void {
      open = true;
      refresh();
    },
    closed(): void {
      take.now();
      open = false;
    },
    goTo: (line, column) => area.goTo(line, column),
    goToPath(path): void {
      for (let length = path.length; length >= 0; length--) {
        const place = placeOf(store.text, path.slice(0, length));
        if (place) return area.goTo(place.line, place.column);
      }
    },
  };
}

