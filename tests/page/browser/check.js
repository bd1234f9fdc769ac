// Tries the page from within and passes its findings to the outer page as JSON: see test_browser.cpp.
"use strict";
addEventListener("load", async () => {
  const found = { errors: window.pageErrors, width: innerWidth };
  const frame = () => new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go)));  // what is due is drawn
  const press = (key, more = {}) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...more }));
  const page = window.elsie;
  try {
    await frame();
    found.dark = matchMedia("(prefers-color-scheme: dark)").matches;
    found.at_load = { time: page.time, robot: page.robot };
    found.resources = performance.getEntriesByType("resource").map((entry) => entry.name.slice(0, 60)).filter((name) => !name.startsWith("data:"));
    found.space = page.shows_space;
    found.end = page.run.end;
    found.robots = page.run.robots.map((robot) => robot.id);
    found.scripts = document.scripts.length;
    found.images = document.images.length;
    found.hacked = window.hacked ?? null;
    found.scrollWidth = document.documentElement.scrollWidth;
    found.beyond = [...document.querySelectorAll("main *")]
      .filter((element) => element.getBoundingClientRect().right > innerWidth + 8.5)
      .map((element) => element.outerHTML.slice(0, 120));
    found.nameless = [...document.querySelectorAll("button, select, input, canvas[role]")]
      .filter((element) => !(element.getAttribute("aria-label") || element.textContent.trim()))
      .map((element) => element.outerHTML.slice(0, 120));

    // The legend of the fields at the start and at the end.
    const legend = () => (document.getElementById("fields").hidden ? [] : [...document.querySelectorAll("#fields li:not([hidden])")].map((row) => [...row.childNodes].map((part) => part.textContent).filter(Boolean).join(" ")));
    found.fields = [0, page.run.end].map((time) => {
      page.seek(time);
      return legend();
    });
    page.seek(found.at_load.time);

    // Nothing may cover what is looked at.
    document.getElementById("sketches").click();
    // Where robots are at three instants, and the colours of the places behind their fronts then and at the first instant.
    const look_at = (robot) => {
      const pose = page.pose(robot.id), half = 0.42 * robot.size[0];
      const rear = [robot.middle[0] - half, robot.middle[1]];
      const place = [pose.x + Math.cos(pose.h) * rear[0], pose.y + Math.sin(pose.h) * rear[0], robot.deck];
      return { id: robot.id, pose, place, colour: robot.colour, shown: found.space ? page.pixel(place) : null };
    };
    found.instants = [0.25, 0.5, 1].map((part) => {
      const time = part * page.run.end;
      page.seek(time);
      return { time, robots: page.run.robots.map(look_at) };
    });
    page.seek(0);
    if (found.space) {
      press("f");
      found.followed = look_at(page.run.robots[0]);
      press("o");
      for (const instant of found.instants) for (const robot of instant.robots) robot.at_start = page.pixel(robot.place);
    }

    // Keys.
    press("End");
    found.at_end = page.time;
    press("Home");
    found.at_home = page.time;
    press(" ");
    found.plays = page.playing;
    found.play_label = document.getElementById("play").getAttribute("aria-label");
    press(" ");
    found.pauses = !page.playing;
    press("Home");
    press(".");
    found.first_event = [page.time, page.run.events.find((event) => event.time > 1e-3)?.time ?? 0];
    press("2");
    found.second = page.robot;

    // The slider, its text for readers, and the address.
    const slider = document.getElementById("time");
    slider.value = page.run.end / 2;
    slider.dispatchEvent(new Event("input"));
    await frame();
    found.slid = page.time;
    found.text = slider.getAttribute("aria-valuetext");
    found.address = location.hash;
    const arrived = new Promise((go) => addEventListener("hashchange", go, { once: true }));
    location.hash = "#t=1.5&robot=" + encodeURIComponent(found.robots[0]);
    await arrived;
    await frame();
    found.linked = { time: page.time, robot: page.robot };

    // A button that a pointer has pressed does not keep the keys.
    const trails = document.getElementById("trails");
    trails.focus();
    trails.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
    trails.click();
    found.holds_keys = document.activeElement === trails;
    trails.click();

    // Touch: a finger turns the view, two fingers come nearer.
    if (found.space) {
      const canvas = document.getElementById("world"), box = canvas.getBoundingClientRect();
      const touch = (type, pointerId, x, y) => canvas.dispatchEvent(new PointerEvent(type, {
        pointerId, pointerType: "touch", bubbles: true, clientX: box.left + x, clientY: box.top + y, buttons: 1 }));
      canvas.setPointerCapture = () => {};
      const corner = () => page.project([1, 1, 0]).join();
      const views = [corner()];
      touch("pointerdown", 5, 60, 60);
      touch("pointermove", 5, 110, 70);
      touch("pointerup", 5, 110, 70);
      page.seek(page.time);
      views.push(corner());
      touch("pointerdown", 6, 60, 60);
      touch("pointerdown", 7, 100, 60);
      touch("pointermove", 7, 160, 60);
      touch("pointerup", 6, 60, 60);
      touch("pointerup", 7, 160, 60);
      page.seek(page.time);
      views.push(corner());
      found.views = new Set(views).size;
    }

    const picture = document.querySelector("#picture img");
    found.picture = { shown: picture.getBoundingClientRect().width > 100, loaded: picture.naturalWidth > 0 };
    found.lanes = document.querySelectorAll("#rows .row").length;
    const chart = document.getElementById("chart"), bytes = chart.getContext("2d").getImageData(0, 0, chart.width, chart.height).data;
    found.inked = bytes.some((byte, i) => i % 4 === 3 && byte > 200);
    found.decides = document.getElementById("who").textContent;
    found.title = document.querySelector("h1").textContent;
    found.why = document.getElementById("why").textContent;
    found.first_listed = document.querySelector("#events .what")?.textContent.replace("r1 · ", "");
    found.listed = document.querySelectorAll("#events li").length;
  } catch (error) {
    found.errors.push(String(error.stack ?? error));
  }
  parent.postMessage(JSON.stringify(found), "*");
});
