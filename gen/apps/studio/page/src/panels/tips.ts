/** Tips: what an element's data-tip says, shown when it is pointed at or has the focus of the keyboard. */

import { el } from "../dom";

const DELAY = 350;

export function mountTips(): void {
  const tip = el("div.tip", { role: "tooltip", id: "tip", hidden: true });
  document.body.append(tip);
  let owner: HTMLElement | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;

  const hide = (): void => {
    clearTimeout(timer);
    owner?.removeAttribute("aria-describedby");
    owner = null;
    tip.hidden = true;
  };
  const show = (target: HTMLElement): void => {
    if (!target.isConnected) return;
    // In a dialog, only what is inside of it lies on top.
    (target.closest("dialog") ?? document.querySelector("main") ?? document.body).append(tip);
    owner = target;
    tip.textContent = target.dataset.tip!;
    tip.hidden = false;
    target.setAttribute("aria-describedby", "tip");
    const at = target.getBoundingClientRect();
    const size = tip.getBoundingClientRect();
    const below = at.bottom + size.height + 8 < innerHeight;
    tip.style.left = `${Math.max(6, Math.min(at.left, innerWidth - size.width - 6))}px`;
    tip.style.top = `${below ? at.bottom + 5 : at.top - size.height - 5}px`;
  };
  const over = (event: Event): void => {
    const target = (event.target as Element).closest?.<HTMLElement>("[data-tip]");
    if (target === owner) return;
    hide();
    if (target?.dataset.tip) timer = setTimeout(() => show(target), event.type === "focusin" ? 0 : DELAY);
  };
  document.addEventListener("pointerover", over);
  document.addEventListener("focusin", (event) => {
    if ((event.target as Element).matches(":focus-visible")) over(event);
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("pointerdown", hide);
  document.addEventListener("keydown", (event) => event.key === "Escape" && hide());
}
