"use strict";
{  // What is wider than its place can be moved by keys as well.
  const boxes = document.querySelectorAll(".scroll, .derivation p:not(:first-child, :where(li:not(.n)) > :last-child), .sheet figure");
  const reach = () => {
    for (const box of boxes) {
      if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
      else box.removeAttribute("tabindex");
    }
  };
  new ResizeObserver(reach).observe(document.body);
  document.fonts.ready.then(reach);
  addEventListener("toggle", reach, true);
}
{  // Folded sections open for printing, and where a link leads to one.
  addEventListener("beforeprint", () => { for (const one of document.querySelectorAll("details")) one.open = true; });
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const section = target && target.closest("details");
    if (section) section.open = true;
  };
  addEventListener("hashchange", reveal);
  reveal();
}
