"use strict";
{  // What is wider than its place can be moved by keys as well.
  const boxes = document.querySelectorAll(".scroll, .right");
  const reach = () => {
    for (const box of boxes) {
      if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
      else box.removeAttribute("tabindex");
    }
  };
  new ResizeObserver(reach).observe(document.body);
}
