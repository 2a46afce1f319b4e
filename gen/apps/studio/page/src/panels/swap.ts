/** Another bark, skin or stone, or other leaves, for what is selected: those of all presets, chosen by their pictures. */

import * as api from "../api";
import { el, icon } from "../dom";
import { Looks } from "../looks";
import { applyMaterial, exampleOf, partsFor, shippedMaterials, type Material } from "../materials";
import type { Store } from "../store";
import { dialog } from "./dialogs";
import { calledBy } from "./species_panel";

export async function swap(store: Store, entry: number, what: "leaves" | "surface"): Promise<void> {
  const looks = new Looks();
  const found = partsFor(store.schema, await shippedMaterials(store.presets), store.preset.kindOf(entry), what);
  const pictureOf = (material: Material): HTMLElement => {
    const picture = el<HTMLImageElement>("img", { alt: "" });
    picture.addEventListener("error", () => picture.replaceWith(el("span.blank", { "aria-hidden": "true" }, icon("gallery"))));
    const listed = store.presets.find(({ file }) => file === material.file);
    if (what === "surface") looks.want(picture, (signal) => api.ball(exampleOf(material), 0, signal));
    else if (listed?.picture) picture.src = api.galleryPicture(listed.picture);
    else looks.want(picture, (signal) => api.look(material.file, signal));
    return picture;
  };
  const chosen = await dialog(what === "leaves" ? "Other leaves" : "Another surface", (close) => [
    el("ul.library-cards.swaps", { "aria-label": "To choose from", "data-testid": "swaps" }, ...found.map((material, i) =>
      el("li", {}, el("button.card", { type: "button", "data-testid": `swap:${i}`, "data-tip": `${material.name} of ${calledBy(material.file)}`, click: () => close(String(i)) }, pictureOf(material), el("span", {}, calledBy(material.file)))))),
    !found.length && el("p", {}, "No preset has any that this kind could take."),
    el("div.answers", {}, el("button.primary", { type: "button", click: () => close(null) }, "Cancel")),
  ], "swap");
  looks.stop();
  if (chosen !== null) applyMaterial(store, found[Number(chosen)]!, store.meant(entry));
}
