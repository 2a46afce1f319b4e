import { el } from "../dom";

/** A button of a tool; one whose label is a mere sign is called by what it does. */
export function toolButton(testid: string, label: string, tip: string, click: () => void): HTMLElement {
  return el("button.small", { type: "button", "data-testid": testid, "data-tip": tip, "aria-label": /\w/.test(label) ? null : tip, click }, label);
}
