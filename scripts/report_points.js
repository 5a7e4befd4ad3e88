// The points of the acceptance of reports that a browser can measure, put into a copy of a page by report_points.sh. MEDIA is
// "print", where the copy has the rules for print at the width of the printed area, or "phone". The findings, a line each, are
// left in the attribute data-findings of the body.
const findings = [];
const report = (point, text) => findings.push(`point ${point}: ${text.replace(/\s+/g, " ").slice(0, 110)}`);
const all = (selector) => [...document.querySelectorAll(selector)];
const is_seen = (e) => { const b = e.getBoundingClientRect(); return b.width > 0 && b.height > 0 && getComputedStyle(e).visibility !== "hidden"; };
const overlap = (a, b) => ({ w: Math.min(a.right, b.right) - Math.max(a.left, b.left), h: Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) });
const scrolls = (e) => {
  for (; e && e !== document.body; e = e.parentElement) if (/auto|scroll/.test(getComputedStyle(e).overflowX)) return true;
  return false;
};
const texts_of = (svg) => [...svg.querySelectorAll("text")].filter((t) => t.textContent.trim() && is_seen(t));

function deciding_blocks() {
  const sheet = document.querySelector(".sheet");
  if (!sheet) return report(1, "no page 1");
  for (const s of [".title-block", ".finding b", ".signatures tbody"]) if (!sheet.querySelector(s)) report(1, `no ${s} on page 1`);
  if (sheet.querySelectorAll(".signatures tbody tr").length !== 3) report(1, "not three lines of signatures");
  const titles = all(".sheet h2").map((h) => h.textContent);
  for (const t of ["Outside the scope of loadpath", "Accepted by user", "Not assessed", "Not considered", "Assumptions"])
    if (!titles.some((h) => h.includes(t))) report(1, `no block "${t}"`);
}

function edges() {
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width) report(6, `the page is ${document.documentElement.scrollWidth} wide in ${width}`);
  for (const e of all("main *")) {
    if (e.closest("svg") && e.tagName !== "svg") continue;
    const box = e.getBoundingClientRect();
    if (box.width > 0 && (box.right > width + 0.5 || box.left < -0.5) && !scrolls(e)) report(6, `${e.tagName} from ${box.left.toFixed(0)} to ${box.right.toFixed(0)}: ${e.textContent}`);
  }
}

// The width of a cell or paragraph against that of its longest word: browsers give a block less only where it is forced to.
function words() {
  const probe = document.createElement("canvas").getContext("2d");
  for (const e of all("main td, main th, main dd, .derivation > li > *")) {
    if (!is_seen(e)) continue;
    const style = getComputedStyle(e);
    if (e.clientWidth < 3 * parseFloat(style.fontSize) && e.textContent.trim().length > 12 && !e.querySelector("math, i")) report(7, `${e.clientWidth} px for: ${e.textContent}`);
    if (e.querySelector("code, wbr, math, i") || e.closest(".signatures, .title-block")) continue;
    probe.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    for (const word of e.matches(".derivation > li > *") ? [] : e.innerText.split(/[\s\u2009/–-]+/)) {
      if (word.length > 5 && word.length < 26 && !/[._=]/.test(word) && probe.measureText(word).width > e.clientWidth + 2 && !scrolls(e)) report(7, `"${word}" in ${e.clientWidth} px`);
    }
  }
}

function labels() {
  for (const svg of all("figure svg")) {
    const frame = svg.getBoundingClientRect(), texts = texts_of(svg), boxes = texts.map((t) => t.getBoundingClientRect());
    boxes.forEach((a, i) => {
      if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 4 || a.bottom > frame.bottom + 4) report(8, `out of the figure: ${texts[i].textContent}`);
      for (let k = i + 1; k < boxes.length; ++k) {
        const o = overlap(a, boxes[k]);
        if (o.w > 2 && o.h > 0.35 * Math.min(a.height, boxes[k].height)) report(8, `over each other: ${texts[i].textContent} | ${texts[k].textContent}`);
      }
    });
  }
}

function formulas() {
  for (const list of all(".derivation")) {
    const parts = [...list.querySelectorAll(":scope > li > *")].filter(is_seen);
    const boxes = parts.map((p) => { const r = document.createRange(); r.selectNodeContents(p); return r.getBoundingClientRect(); });
    for (let i = 0; i < boxes.length; ++i) for (let k = i + 1; k < Math.min(boxes.length, i + 10); ++k) {
      const o = overlap(boxes[i], boxes[k]);
      if (o.w > 1 && o.h > 0.3 * Math.min(boxes[i].height, boxes[k].height)) report(10, `${parts[i].textContent} | ${parts[k].textContent}`);
    }
  }
}

function sizes() {
  const points = (e, scale = 1) => parseFloat(getComputedStyle(e).fontSize) * 0.75 * scale;
  for (const e of all("main p, main td, main th, main dd, main dt, main h2, main h3, figcaption"))
    if (is_seen(e) && e.textContent.trim() && points(e) < 6.4 - 1e-6) report(11, `${points(e).toFixed(2)} pt: ${e.textContent}`);
  for (const svg of all("figure svg")) {
    const scale = svg.getBoundingClientRect().width / (svg.viewBox.baseVal.width || 1);
    for (const t of texts_of(svg)) if (points(t, scale) < 6.4 - 1e-6) report(11, `${points(t, scale).toFixed(2)} pt in a figure: ${t.textContent}`);
  }
  const lefts = new Set(all(".sheet .derivation > li:not(.n) > :last-child").filter(is_seen).map((e) => Math.round(e.getBoundingClientRect().left)));
  if (lefts.size > 1) report(12, `notes begin at ${[...lefts].join(", ")}`);
}

function clipped() {
  for (const e of all("main p, main td, main th, main dd, main h2"))
    if (e.clientWidth > 0 && e.scrollWidth > e.clientWidth + 1 && /hidden|clip/.test(getComputedStyle(e).overflowX)) report(13, e.textContent);
}

function rows() {
  for (const tr of all(".sheet:first-of-type tbody tr")) {
    const cells = [...tr.querySelectorAll("td")].map((c) => c.textContent.trim());
    if (!tr.closest(".signatures") && cells.length > 1 && !cells[0].endsWith("appendix") && cells.slice(1).every((c) => /^[-–]?$/.test(c))) report(21, cells.join(" | "));
  }
  for (const e of all(".sheet p.finding, .sheet h2, .sheet td, .sheet p.note")) {
    const found = e.textContent.match(/\b[ux]_[A-Za-z]\w*/);
    if (found && !e.querySelector("math, i, code")) report(22, `${found[0]} in: ${e.textContent}`);
  }
}

function contrast() {
  const channels = (c) => { const m = c.match(/[\d.]+/g).map(Number); return { rgb: m.slice(0, 3), a: m.length > 3 ? m[3] : 1 }; };
  const light = (rgb) => rgb.map((v) => v / 255).map((v) => (v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)).reduce((s, v, i) => s + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = (e) => { for (; e; e = e.parentElement) { const c = channels(getComputedStyle(e).backgroundColor); if (c.a > 0.9) return c.rgb; } return [255, 255, 255]; };
  const known = new Set();
  for (const e of all("main p, main td, main th, main dd, main dt, main h2, main small, main a, main b, main .state, main .unit, figure text")) {
    if (!is_seen(e)) continue;
    const style = getComputedStyle(e), color = e.tagName === "text" ? style.fill : style.color;
    if (!/^rgb/.test(color)) continue;
    const l = [light(channels(color).rgb), light(ground(e))].sort((a, b) => b - a), ratio = (l[0] + 0.05) / (l[1] + 0.05);
    if (ratio < 4.5 && !known.has(color)) { known.add(color); report(25, `contrast ${ratio.toFixed(2)} of ${color}: ${e.textContent}`); }
  }
}

addEventListener("load", () => document.fonts.ready.then(() => {
  for (const d of all("details")) d.open = true;
  const checks = MEDIA === "phone" ? [edges, contrast] : [deciding_blocks, edges, words, labels, formulas, sizes, clipped, rows, contrast];
  for (const check of checks) check();
  document.body.setAttribute("data-findings", findings.slice(0, 12).join("\n") || "none");
}));
