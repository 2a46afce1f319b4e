/** Links and files of what is shown. */

import { el } from "../../../gen/apps/studio/page/src/dom";

export function save(name: string, blob: Blob): void {
  const link = el<HTMLAnchorElement>("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A button that copies the address, which `keep` brings up to date. */
export function copyLink(keep: () => void): HTMLElement {
  const copy = el("button", { type: "button", "data-testid": "link", click: async () => {
    keep();
    // Only secure pages have a clipboard.
    const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    copy.textContent = copied ? "Copied" : "It is in the address bar";
    setTimeout(() => (copy.textContent = "Copy link"), 2000);
  } }, "Copy link");
  return copy;
}
