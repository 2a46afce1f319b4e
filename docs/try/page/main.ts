/** The page: a grammar that is typed, a tree that grows for light, or a coral. The part of the address behind # says which. */

import "../../../gen/apps/studio/page/src/styles/base.css";
import "../../../gen/apps/studio/page/src/styles/editors.css";
import "./style.css";

import { el } from "../../../gen/apps/studio/page/src/dom";
import { coralPage, isCoralLink } from "./coral";
import { coralOf, engine, treeOf } from "./engine";
import { grammarPage } from "./grammar";
import { isTreeLink, treePage } from "./tree";

const pages = [
  { name: "Grammars", href: "#", page: grammarPage },
  { name: "Trees", href: "#tree=", page: treePage },
  { name: "Corals", href: "#coral=", page: coralPage },
];
const links = pages.map(({ name, href }) => el<HTMLAnchorElement>("a", { href, "data-testid": `to-${name.toLowerCase()}` }, name));
const bar = el("nav", { "aria-label": "What is shown" }, el("b", {}, "Frond"), ...links);
document.body.append(bar);

function open(): void {
  const link = location.hash.slice(1), page = isTreeLink(link) ? treePage : isCoralLink(link) ? coralPage : grammarPage;
  if (!page.panel.isConnected) {
    bar.nextElementSibling?.remove();
    document.body.append(page.panel);
  }
  links.forEach((one, i) => one.setAttribute("aria-current", String(pages[i]!.page === page)));
  page.open(link);
}
window.addEventListener("hashchange", open);
open();

// For tests.
Object.assign(window, { frond: { engine, treeOf, coralOf, busy: () => pages.some(({ page }) => page.busy()) } });
