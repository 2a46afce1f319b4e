/** The page: a grammar that is typed, or a tree that grows for light. The part of the address behind # says which. */

import "../../../gen/apps/studio/page/src/styles/base.css";
import "../../../gen/apps/studio/page/src/styles/editors.css";
import "./style.css";

import { el } from "../../../gen/apps/studio/page/src/dom";
import { engine, treeOf } from "./engine";
import { grammarPage } from "./grammar";
import { isTreeLink, treePage } from "./tree";

const links = [["#", "Grammars"], ["#tree=", "Trees"]].map(([href, name]) => el<HTMLAnchorElement>("a", { href: href!, "data-testid": `to-${name!.toLowerCase()}` }, name!));
const bar = el("nav", { "aria-label": "What is shown" }, ...links);
document.body.append(bar);

function open(): void {
  const link = location.hash.slice(1), page = isTreeLink(link) ? treePage : grammarPage;
  if (!page.panel.isConnected) {
    bar.nextElementSibling?.remove();
    document.body.append(page.panel);
  }
  links.forEach((one, i) => one.setAttribute("aria-current", String((i === 1) === (page === treePage))));
  page.open(link);
}
window.addEventListener("hashchange", open);
open();

// For tests.
Object.assign(window, { frond: { engine, treeOf, busy: () => grammarPage.busy() || treePage.busy() } });
