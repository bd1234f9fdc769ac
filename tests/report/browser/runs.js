// Plays runs of the page and passes its findings to the outer page as JSON: see test_browser.cpp.
"use strict";
addEventListener("load", async () => {
  const found = { errors: window.pageErrors, width: innerWidth };
  const until = async (is_so) => {
    for (let i = 0; i < 2000 && !is_so(); ++i) await new Promise(requestAnimationFrame);
    return Boolean(is_so());
  };
  try {
    const frame = document.querySelector("#watch iframe");
    const viewer = () => frame.contentWindow.elsie;
    const ready = (id) => until(() => frame.dataset.run === id && viewer()?.run && frame.contentDocument.readyState === "complete");
    const asked = new URLSearchParams(location.hash.slice(1));
    if (asked.has("run")) {
      await ready(asked.get("run"));
      found.linked = { run: frame.dataset.run, time: viewer().time, robot: viewer().robot, top: frame.getBoundingClientRect().top };
    }
    frame.scrollIntoView({ behavior: "instant" });
    found.first = await until(() => frame.dataset.run);
    const buttons = [...document.querySelectorAll("#watch .play")];
    found.buttons = buttons.map((button) => button.getAttribute("aria-label"));
    found.runs = [];
    for (const button of buttons.slice(0, 2)) {
      const id = button.textContent;
      const loaded = new Promise((go) => frame.addEventListener("load", go, { once: true }));
      button.click();
      await loaded;
      await ready(id);
      const plays = await until(() => viewer().time > 0);
      viewer().play(false);
      found.runs.push({
        id, plays, space: viewer().shows_space, end: viewer().run.end,
        title: frame.contentDocument.querySelector("h1").textContent,
        flat: frame.contentDocument.body.classList.contains("flat"),
        picture: frame.contentDocument.getElementById("from-above").naturalWidth,
        current: [...document.querySelectorAll("#watch [aria-current]")].map((row) => row.cells[0].textContent),
        instants: [0, 0.5, 1].map((part) => {
          viewer().seek(part * viewer().run.end);
          return { time: viewer().time, pose: viewer().pose(viewer().run.robots[0].id) };
        }),
        address: location.hash,
      });
    }
    found.resources = performance.getEntriesByType("resource").map((entry) => entry.name.slice(0, 60)).filter((name) => !name.startsWith("data:"));
    found.hacked = frame.contentWindow.hacked ?? window.hacked ?? null;
    found.scrollWidth = document.documentElement.scrollWidth;
    const inner = () => frame.contentDocument.documentElement.scrollHeight;
    found.fits = await until(() => inner() <= frame.clientHeight);
    found.frame = { width: frame.clientWidth, height: frame.clientHeight, inner: inner(), wide: frame.contentDocument.documentElement.scrollWidth };
  } catch (error) {
    found.errors.push(String(error.stack ?? error));
  }
  parent.postMessage(JSON.stringify(found), "*");
});
