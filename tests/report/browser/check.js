// Checks the page from within and passes its findings to the outer page as JSON: see test_browser.cpp.
"use strict";
addEventListener("load", () => {
  const found = { errors: window.pageErrors, width: innerWidth };
  found.dark = matchMedia("(prefers-color-scheme: dark)").matches;
  found.resources = performance.getEntriesByType("resource").map((entry) => entry.name);
  const foldable = [...document.querySelectorAll("details")];
  found.details = foldable.length;
  for (const details of foldable) details.open = true;

  // Elements that reach beyond the window, except in boxes that scroll.
  const scrolls = (element) => element.closest(".scroll, pre") !== null;
  found.scrollWidth = document.documentElement.scrollWidth;
  found.beyond = [...document.querySelectorAll("main *")]
    .filter((element) => !scrolls(element) && !element.closest("svg"))
    .filter((element) => element.getBoundingClientRect().right > innerWidth + 0.5)
    .map((element) => element.outerHTML.slice(0, 120));

  // Tables by factor that must be scrolled.
  found.wide = [...document.querySelectorAll("#factors .scroll")]
    .filter((box) => box.scrollWidth > box.clientWidth + 1)
    .map((box) => box.textContent.slice(0, 120));

  // Invisible figures, and texts that stick out of their figures.
  const figures = [...document.querySelectorAll("figure")];
  found.figures = figures.length;
  const pictures = [...document.querySelectorAll("figure svg")].filter((svg) => !svg.parentNode.closest("svg"));
  found.pictures = pictures.length;
  found.flat = pictures
    .filter((svg) => { const box = svg.getBoundingClientRect(); return box.width < 8 || box.height < 8; })
    .map((svg) => svg.outerHTML.slice(0, 120));
  found.tall = pictures
    .filter((svg) => svg.getBoundingClientRect().width > innerWidth)
    .map((svg) => svg.outerHTML.slice(0, 120));
  found.cut = [];
  found.small = [];
  for (const text of document.querySelectorAll("svg text")) {
    const box = text.getBoundingClientRect();
    if (box.width === 0) continue;
    if (box.left < -0.5 || box.right > innerWidth + 0.5) found.cut.push(text.textContent);
    const matrix = text.getScreenCTM();
    const scale = Math.hypot(matrix.a, matrix.b);
    const size = parseFloat(getComputedStyle(text).fontSize) * scale;
    if (size < 8.9) found.small.push(text.textContent + ": " + size.toFixed(1));
  }

  // Texts with little contrast to their background (WCAG 2: 4.5, or 3 for large ones).
  const parts = (colour) => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const luminance = ([r, g, b]) => [r, g, b]
    .map((v) => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = (element) => {
    // A label in a map has its own ground around its letters.
    if (element.getAttribute("paint-order") === "stroke") return parts(getComputedStyle(element).stroke);
    // A tile's text comes after its tile.
    const tile = element.tagName === "text" ? element.previousElementSibling?.getAttribute("fill") : null;
    if (tile?.startsWith("#")) return [1, 3, 5].map((at) => parseInt(tile.slice(at, at + 2), 16));
    for (; element; element = element.parentElement) {
      const colour = parts(getComputedStyle(element).backgroundColor);
      if (colour.length === 3 || (colour.length === 4 && colour[3] > 0)) return colour;
    }
    return [255, 255, 255];
  };
  found.faint = [];
  for (const element of document.querySelectorAll("main *")) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
    if (!own || ["SCRIPT", "STYLE"].includes(element.tagName) || element.getBoundingClientRect().width === 0) continue;
    const style = getComputedStyle(element);
    const ink = element.namespaceURI.endsWith("svg") ? style.fill : style.color;
    const [a, b] = [luminance(parts(ink)), luminance(ground(element))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const large = parseFloat(style.fontSize) >= 24;
    if (ratio < (large ? 3 : 4.5)) found.faint.push(element.textContent.trim().slice(0, 40) + " " + ratio.toFixed(2));
  }

  // The comparison can be sorted, by numbers and by words, both ways.
  const table = document.querySelector("#comparison table");
  const column = (number) => [...table.tBodies[0].rows].map((row) => row.cells[number].dataset.v ?? row.cells[number].textContent);
  const last = table.tHead.rows[0].cells.length - 1;
  const button = table.tHead.rows[0].cells[last].querySelector("button");
  found.before = column(last);
  button.click();
  found.upwards = column(last);
  found.sortedAs = table.tHead.rows[0].cells[last].getAttribute("aria-sort");
  button.click();
  found.downwards = column(last);

  // Cells can be chosen by words.
  const input = document.querySelector(".filter input");
  found.filter = input !== null;
  if (input) {
    input.value = "FUSION 2";
    input.dispatchEvent(new Event("input"));
    found.chosen = [...document.querySelectorAll(".cell")].filter((cell) => !cell.hidden).map((cell) => cell.dataset.cell);
    found.chosenRows = [...table.tBodies[0].rows].filter((row) => !row.hidden).length;
  }
  found.anchors = [...document.querySelectorAll("a")].filter((a) => !document.querySelector(a.hash)).length;

  parent.postMessage(JSON.stringify(found), "*");
});
