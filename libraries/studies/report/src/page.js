// The page is readable without this script.
"use strict";
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const value = (row, column) => {
    const cell = row.cells[column];
    const text = cell.dataset.v ?? cell.textContent.trim();
    return text === "" ? null : isNaN(text) ? text : Number(text);
  };
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const up = head.getAttribute("aria-sort") !== "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      const rows = [...body.rows].map((row) => [value(row, column), row]);
      rows.sort(([a], [b]) => {
        if (a === null || b === null) return (a === null) - (b === null);
        const order = typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b));
        return up ? order : -order;
      });
      body.append(...rows.map(([, row]) => row));
    });
  });
}
const cells = document.querySelectorAll("[data-cell]");
const table = document.querySelector("#comparison .scroll");
if (table && document.querySelectorAll(".cell").length > 3) {
  const box = document.createElement("label");
  box.className = "filter";
  const input = document.createElement("input");
  input.type = "search";
  input.placeholder = "Show only cells with these words";
  input.setAttribute("aria-label", "Show only cells with these words");
  box.append(input);
  table.before(box);
  input.addEventListener("input", () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const cell of cells) {
      const label = cell.dataset.cell.toLowerCase();
      cell.hidden = !words.every((word) => label.includes(word));
    }
  });
}
const unfold = () => {
  const folded = document.getElementById(location.hash.slice(1))?.querySelector(":scope > details");
  if (folded) folded.open = true;
};
addEventListener("hashchange", unfold);
unfold();
// Runs to watch: the page has the viewer once, and fills a frame with it and the chosen run.
const player = document.querySelector("#watch iframe");
if (player) {
  const rows = new Map([...document.querySelectorAll("#watch tbody tr")].map((row) => [row.cells[0].textContent, row]));
  const fit = () => {
    const body = player.contentDocument?.body;
    const border = player.offsetHeight - player.clientHeight;
    player.style.height = body && player.clientWidth <= 820 ? `${body.scrollHeight + border}px` : "";
  };
  const watch = (id, plays) => {
    const run = JSON.parse(document.getElementById(`run-${id}`).textContent);
    for (const [own, row] of rows) own === id ? row.setAttribute("aria-current", "true") : row.removeAttribute("aria-current");
    player.dataset.run = id;
    player.onload = () => {
      new player.contentWindow.ResizeObserver(() => requestAnimationFrame(fit)).observe(player.contentDocument.body);
      if (plays) player.contentWindow.elsie.play(true);
    };
    player.srcdoc = player.dataset.viewer.replace(/\{\{(\w+)\}\}/g, (_, name) => run[name]);
  };
  for (const [id, row] of rows) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "play";
    button.textContent = id;
    button.setAttribute("aria-label", `Play run ${id}`);
    button.addEventListener("click", () => {
      watch(id, true);
      player.scrollIntoView({block: "nearest"});
    });
    row.cells[0].replaceChildren(button);
  }
  player.hidden = false;
  addEventListener("resize", fit);
  // The first run is there when the reader comes to it; or the one in the address.
  const asked = () => new URLSearchParams(location.hash.slice(1)).get("run");
  const show_asked = () => {
    if (!rows.has(asked()) || player.dataset.run === asked()) return;
    watch(asked(), false);
    player.scrollIntoView({behavior: "instant"});
  };
  addEventListener("hashchange", show_asked);
  show_asked();
  new IntersectionObserver((seen, observer) => {
    if (!seen.some((each) => each.isIntersecting)) return;
    observer.disconnect();
    if (!player.dataset.run) watch(rows.keys().next().value, false);
  }, {rootMargin: "400px"}).observe(player);
}
if (navigator.clipboard) {
  for (const code of document.querySelectorAll("code.command")) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "copy";
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(code.textContent);
      button.textContent = "copied";
      setTimeout(() => (button.textContent = "copy"), 1500);
    });
    code.after(button);
  }
}
let opened = [];
addEventListener("beforeprint", () => {
  opened = [...document.querySelectorAll(".cell > details:not([open])")];
  for (const details of opened) details.open = true;
});
addEventListener("afterprint", () => {
  for (const details of opened) details.open = false;
});
