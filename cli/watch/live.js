"use strict";
(() => {
  const own = document.currentScript;
  const at = (name) => location.pathname + name;
  const text = async (name) => {
    const answer = await fetch(at(name), { cache: "no-store" });
    if (!answer.ok) throw new Error(answer.statusText);
    return answer.text();
  };

  // Over the page: the issues of a project that cannot be solved, or the notice that the program has ended.
  const look = document.createElement("style");
  look.textContent = `
    #watch { position: fixed; inset: auto 0 0 0; max-height: 60vh; overflow: auto; z-index: 10; margin: 0;
      padding: 0.8rem 1.2rem; border-top: 4px solid #b3261e; background: #fff4f2; color: #1c1b1a;
      font: 0.85rem/1.45 ui-monospace, "DejaVu Sans Mono", monospace; white-space: pre; }
    #watch[hidden] { display: none; }
    @media (prefers-color-scheme: dark) { #watch { background: #2b1a18; color: #f3e9e7; border-color: #f2867c; } }
    @media print { #watch { display: none; } }`;
  const over = document.createElement("pre");
  over.id = "watch";
  over.setAttribute("role", "alert");
  over.tabIndex = 0;
  over.hidden = true;
  const tell = (words) => { over.textContent = words; over.hidden = words === ""; };

  // What the reader has opened, moved or chosen, by its order in the page.
  const all = (selector) => [...document.body.querySelectorAll(selector)];
  const playing = (button) => button.dataset.pause !== undefined && button.textContent === button.dataset.pause;
  const state = () => ({
    y: scrollY,
    open: all("details").map((d) => d.open),
    slid: all("input[type=range]").map((i) => i.value),
    chosen: all("select").map((s) => s.selectedIndex),
    playing: all("button").map(playing),
  });
  const restore = (was) => {
    const each = (selector, values, put) => all(selector).forEach((e, n) => n < values.length && put(e, values[n]));
    each("details", was.open, (d, open) => { d.open = open; });
    each("select", was.chosen, (s, n) => {
      if (n < s.options.length && n !== s.selectedIndex) { s.selectedIndex = n; s.dispatchEvent(new Event("change")); }
    });
    each("input[type=range]", was.slid, (i, value) => {
      if (i.value !== value) { i.value = value; i.dispatchEvent(new Event("input")); }
    });
    each("button", was.playing, (b, on) => { if (on) b.click(); });
    scrollTo({ top: was.y, behavior: "instant" });
  };

  const replace = (page) => {
    const next = new DOMParser().parseFromString(page, "text/html");
    const was = state();
    all("button").filter(playing).forEach((b) => b.click());
    next.getElementById("live").remove();
    document.title = next.title;
    document.head.querySelector("style").replaceWith(next.head.querySelector("style"));
    const scripts = [...next.body.querySelectorAll("script:not([type])")];
    scripts.forEach((s) => s.remove());
    document.body.replaceChildren(...next.body.childNodes, over);
    for (const script of scripts) {
      const again = document.createElement("script");  // a parsed one does not run; its names are its own each time
      again.textContent = `(() => {${script.textContent}})();`;
      document.body.append(again);
    }
    restore(was);
  };

  let shown = own.dataset.news;
  const hear = async (news) => {
    try {
      if (news.endsWith("problem")) return tell(await text("problem"));
      if (news !== shown) replace(await text(""));
      shown = news;
      tell("");
    } catch {
      tell("The program has ended: the page is as it was last.");
    }
  };
  document.head.append(look);
  document.body.append(over);
  const news = new EventSource(at("events"));
  let order = Promise.resolve();
  news.onmessage = (event) => { order = order.then(() => hear(event.data)); };
  news.onerror = () => tell("The program has ended: the page is as it was last.");
})();
