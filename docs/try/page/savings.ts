/** Links and files of what is shown. */

import { el } from "../../../gen/apps/studio/page/src/dom";

export function save(name: string, blob: Blob): void {
  const link = el<HTMLAnchorElement>("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Whether a text is in the clipboard now: only secure pages have one, and not every browser lets them. */
const copied = async (text: string): Promise<boolean> => {
  const there = await navigator.clipboard?.writeText(text).then(() => true, () => false);
  return there === true;
};

/** Says something on a button for a while. */
function tell(button: HTMLElement, words: string, usual: string): void {
  button.textContent = words;
  setTimeout(() => (button.textContent = usual), 2000);
}

/** A button that copies the address, which `keep` brings up to date. */
export function copyLink(keep: () => void): HTMLElement {
  const copy = el("button", { type: "button", "data-testid": "link", click: async () => {
    keep();
    tell(copy, (await copied(location.href)) ? "Copied" : "It is in the address bar", "Copy link");
  } }, "Copy link");
  return copy;
}

export interface Handing {
  element: HTMLElement;
  /** Shows the command for the name that it has now. */
  refresh(): void;
}

/** What hands a preset to the program: its file, and the command that films it. `kind` begins the names for tests. */
export function handing(kind: string, preset: () => { name: string; text: string }): Handing {
  const command = (): string => `frond render ${preset().name}.json`;
  const shown = el("code", { "data-testid": `${kind}-command`, tabIndex: 0 });
  const said = el("p.hint", { role: "status", "data-testid": `${kind}-handed` });
  const copy = el("button", { type: "button", "data-testid": `${kind}-copy`, click: async () => tell(copy, (await copied(command())) ? "Copied" : "Select it by hand", "Copy command") }, "Copy command");
  const download = el("button.primary", { type: "button", "data-testid": `${kind}-preset`, click: async () => {
    const { name, text } = preset();
    save(`${name}.json`, new Blob([text], { type: "application/json" }));
    const there = await copied(command());
    said.textContent = `${name}.json is among your downloads${there ? ", and the command is in the clipboard" : ""}. It runs in the folder of that file.`;
  } }, "Save preset");
  const element = el("section.handing", { "aria-label": "For the program" },
    el("h2", {}, "Render it"),
    el("p.hint", {}, "Save the preset, and this films it by POV-Ray, in all its light:"),
    el("div.command", {}, shown, download, copy),
    said);
  const refresh = (): void => {
    if (shown.textContent === command()) return;
    shown.textContent = command();
    said.textContent = "";
  };
  return { element, refresh };
}

/** A text as the part of an address behind #, and back; null where that holds none. */
export function packed(text: string): string {
  let bytes = "";
  for (const byte of new TextEncoder().encode(text)) bytes += String.fromCharCode(byte);
  return btoa(bytes).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}
export function unpacked(fragment: string): string | null {
  try {
    const bytes = Uint8Array.from(atob(fragment.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}
