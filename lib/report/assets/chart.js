"use strict";
for (const box of document.querySelectorAll(".chart")) {
  const data = JSON.parse(box.querySelector("script").textContent);
  const picture = box.querySelector(".picture"), svg = picture.querySelector("svg");
  const here = svg.querySelector("[data-here]"), count = data.points.length;
  const xs = data.x.map((v) => v / 10), ys = data.y.map((v) => v / 10);
  const texts = data.readout.map(([words, list]) => {
    const all = list.split(" ");
    return words.length ? all.map((n) => words[n] ?? n) : all.map((text) => text.replace(/^-/, "−"));
  });
  let at = data.shown;

  const show = (k) => {
    at = k;
    here.setAttribute("transform", `translate(${xs[k]} ${ys[k]})`);
    here.setAttribute("visibility", "visible");
    for (const cell of box.querySelectorAll("[data-readout]")) cell.textContent = texts[cell.dataset.readout][k];
    for (const place of box.querySelectorAll("[data-point]")) place.textContent = data.points[k];
    box.querySelector("[data-verdict]").textContent = texts[texts.length - 1][k];
  };
  // Of all points the one that `far`, of the distances across and down, says is nearest.
  const nearest = (x, y, far) => {
    let best = -1, least = Infinity;
    for (let k = 0; k < count; ++k) {
      const distance = far(xs[k] - x, ys[k] - y);
      if (distance < least) [best, least] = [k, distance];
    }
    return best;
  };
  const pointed = (event) => {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const k = nearest(place.x, place.y, Math.hypot);
    if (k >= 0 && k !== at) show(k);
  };
  const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const keyed = (event) => {
    const way = ways[event.key];
    let k = event.key === "Home" ? 0 : event.key === "End" ? count - 1 : -1;
    if (way) {
      k = nearest(xs[at], ys[at], (dx, dy) => {
        const along = dx * way[0] + dy * way[1], aside = Math.abs(dx * way[1] + dy * way[0]);
        return along > 0.05 ? along + 3 * aside : Infinity;
      });
    }
    if (way || k >= 0) event.preventDefault();
    if (k >= 0) show(k);
  };

  if (count === 0) continue;
  box.querySelector(".readout").hidden = false;
  picture.tabIndex = 0;
  picture.addEventListener("pointermove", pointed);
  picture.addEventListener("pointerdown", pointed);
  picture.addEventListener("keydown", keyed);
  // report.html#point=3436 opens with this point, where it is drawn.
  const asked = /^#point=(\d+)$/.exec(location.hash);
  const found = asked ? data.points.indexOf(+asked[1]) : -1;
  show(found < 0 ? data.shown : found);
}
