"use strict";
for (const box of document.querySelectorAll(".motion")) {
  const data = JSON.parse(box.querySelector("script").textContent);
  const all = (selector) => [...box.querySelectorAll(selector)];
  const column = (changes) => { let sum = 0; return changes.map((c) => (sum += c)); };
  const value = (c, k) => (c.length > 1 ? c[k] : c[0]);
  const links = data.links.map((link) => link.map(column));
  const forces = data.forces.map(([step, ...columns]) => ({ step, columns: columns.map(column) }));
  const places = data.at.split(" "), texts = data.numbers.map((n) => n.split(" "));
  const still = data.shown, last = places.length - 1;
  const [slider] = all("input"), [button] = all("button"), [choice] = all("select");

  const pose = (link, k) => {
    const [x, y, phi] = links[link];
    return [data.step * value(x, k), data.step * value(y, k), data.turn * value(phi, k)];
  };
  const place = ([link, x, y], k) => {
    if (link < 0) return [x, y];
    const [x0, y0, phi0] = pose(link, still), [x1, y1, phi1] = pose(link, k);
    const c = Math.cos(phi1 - phi0), s = Math.sin(phi1 - phi0);
    return [x1 + c * (x - x0) + s * (y - y0), y1 - s * (x - x0) + c * (y - y0)];
  };
  const turned = (link, k) => (link < 0 ? 0 : ((pose(link, still)[2] - pose(link, k)[2]) * 180) / Math.PI);
  const force = (n, k) => forces[n].columns.slice(0, 2).map((c) => forces[n].step * value(c, k));
  const foot = (n, at, k) => {
    const [, , x, y] = forces[n].columns;
    return x ? [data.step * value(x, k), data.step * value(y, k)] : place(at, k);
  };
  const minus = (text) => text.replace(/^-/, "−");
  const round = (v) => Math.round(100 * v) / 100;
  const words = (text) => text.split(" ").map(Number);
  const carried = all("[data-carried]").map((g) => [g, words(g.dataset.carried)]);
  const springs = all("[data-between]").map((g) => [g, words(g.dataset.between)]);
  const arrows = all("[data-force]").map((g) => [g, +g.dataset.force, words(g.dataset.at)]);
  const names = all("[data-name]").map((g) => [g.firstElementChild, +g.dataset.name, words(g.dataset.at)]);
  const couples = all("[data-couple]").map((g) => [g, g.dataset.couple.split(" ")]);
  const plans = all("[data-plan]");

  const draw = (g, [x0, y0], [x1, y1]) => {
    const length = Math.hypot(x1 - x0, y1 - y0), shown = length > 1.5;
    g.setAttribute("visibility", shown ? "inherit" : "hidden");
    if (!shown) return;
    const ex = (x1 - x0) / length, ey = (y1 - y0) / length, head = Math.min(11, 0.7 * length);
    const bx = x1 - head * ex, by = y1 - head * ey, w = 0.34 * head;
    const path = (points) => "M" + points.map((p) => p.map(round).join(" ")).join("L");
    g.children[0].setAttribute("d", path([[x0, y0], [x1 - 0.8 * head * ex, y1 - 0.8 * head * ey]]));
    g.children[1].setAttribute("d", path([[x1, y1], [bx - w * ey, by + w * ex], [bx + w * ey, by - w * ex]]) + "z");
  };
  const put = (text, [x, y], ex, ey, shown) => {
    const half = text.getComputedTextLength() / 2, far = 5 + Math.abs(ex) * half + Math.abs(ey) * 8;
    text.setAttribute("x", round(Math.max(half, Math.min(text.ownerSVGElement.viewBox.baseVal.width - half, x + far * ex))));
    text.setAttribute("y", round(y + far * ey + 4.6));
    text.setAttribute("visibility", shown ? "inherit" : "hidden");
  };

  const scheme = (k) => {
    for (const [g, [link, turning, x, y]] of carried) {
      const [u, v] = place([link, x, y], k);
      g.setAttribute("transform", `translate(${round(u)} ${round(v)}) rotate(${round(turned(turning, k))}) translate(${-x} ${-y})`);
    }
    for (const [g, [i, j, x, y, a, b]] of springs) {
      const [u, v] = place([i, x, y], k), [p, q] = place([j, a, b], k), degree = Math.PI / 180;
      const stretch = Math.hypot(p - u, q - v) / (Math.hypot(a - x, b - y) || 1);
      g.setAttribute("transform", `translate(${round(u)} ${round(v)}) rotate(${round(Math.atan2(q - v, p - u) / degree)}) ` +
        `scale(${stretch.toFixed(4)} 1) rotate(${round(Math.atan2(y - b, a - x) / degree)}) translate(${-x} ${-y})`);
    }
    for (const [list, name] of [[arrows, false], [names, true]]) {
      for (const [g, n, [link, , x, y]] of list) {
        const [u, v] = foot(n, [link, x, y], k), [fx, fy] = force(n, k);
        const dx = data.newton * fx, dy = -data.newton * fy, length = Math.hypot(dx, dy) || 1;
        if (name) put(g, [u + dx, v + dy], dx / length, dy / length, length > 4);
        else draw(g, [u, v], [u + dx, v + dy]);
      }
    }
    for (const [g, [n, sign]] of couples) {
      const signs = data.couples[n];
      g.setAttribute("visibility", signs[k] === sign ? "inherit" : "hidden");
    }
  };
  const polygon = (index, k) => {
    const [scale, sides] = data.plans[index], g = plans[index];
    const points = [[0, 0]];
    for (const [n, sense] of sides) {
      const [fx, fy] = force(n, k), [x, y] = points[points.length - 1];
      points.push([x + sense * scale * fx, y - sense * scale * fy]);
    }
    const middle = (i) => (Math.min(...points.map((p) => p[i])) + Math.max(...points.map((p) => p[i]))) / 2;
    const dx = 130 - middle(0), dy = 120 - middle(1), apart = sides.length === 2 ? 3 : 0;
    const area = points.reduce((sum, [x, y], i) => (i ? sum + points[i - 1][0] * y - x * points[i - 1][1] : 0), 0);
    const out = apart || area < 0 ? 1 : -1;
    sides.forEach((side, i) => {
      const [[x0, y0], [x1, y1]] = [points[i], points[i + 1]], length = Math.hypot(x1 - x0, y1 - y0) || 1;
      const nx = -(y1 - y0) / length, ny = (x1 - x0) / length;
      const from = [x0 + dx + apart * nx, y0 + dy + apart * ny], to = [x1 + dx + apart * nx, y1 + dy + apart * ny];
      draw(g.querySelector(`[data-side="${i}"]`), from, to);
      const middles = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
      put(g.querySelector(`[data-side-name="${i}"]`).firstElementChild, middles, out * nx, out * ny, length > 4);
    });
  };
  const show = (k) => {
    scheme(k);
    if (choice) {
      plans.forEach((g, n) => g.setAttribute("visibility", n === choice.selectedIndex ? "visible" : "hidden"));
      box.querySelector(".plan-of span").textContent = choice.value;
      polygon(choice.selectedIndex, k);
    }
    box.querySelector("[data-axis]").textContent = minus(places[k]);
    all("[data-number]").forEach((cell, n) => (cell.textContent = minus(texts[n][k])));
    slider.setAttribute("aria-valuetext", `${places[k]}${slider.dataset.unit}`);
  };
  const go = (k) => { slider.value = k; show(k); };

  let playing = 0;
  const play = button.textContent;
  const stop = () => { cancelAnimationFrame(playing); playing = 0; button.textContent = play; };
  button.addEventListener("click", () => {
    if (playing) return stop();
    button.textContent = button.dataset.pause;
    const begun = performance.now(), first = +slider.value;
    const tick = (now) => {
      go((first + Math.floor(((now - begun) / 6000) * (last + 1))) % (last + 1));
      playing = requestAnimationFrame(tick);
    };
    playing = requestAnimationFrame(tick);
  });
  slider.addEventListener("input", () => { stop(); show(+slider.value); });
  if (choice) choice.addEventListener("change", () => show(+slider.value));
  button.hidden = matchMedia("(prefers-reduced-motion: reduce)").matches;
  slider.setAttribute("aria-valuetext", `${places[still]}${slider.dataset.unit}`);
  box.querySelector(".controls").hidden = last === 0;

  // report.html#position=90 opens at 90 degrees.
  const asked = /^#position=(-?[\d.]+)$/.exec(location.hash);
  if (asked) {
    const away = places.map((p) => Math.abs(p - asked[1]));
    slider.value = away.indexOf(Math.min(...away));
    slider.dispatchEvent(new Event("input"));
  }
}
