// The page: what the user does, and what follows from it.
const find = (id) => document.getElementById(id);
const read_run = () => {
  try {
    return new Run(JSON.parse(new TextDecoder().decode(inflate(bytes_of(find("data").textContent.trim())))));
  } catch (error) {
    document.querySelector(".outcome").textContent = "The data of this page are damaged: get the file again, or make it anew with elsie page.";
    throw error;
  }
};
const run = read_run();
const timeline = new Timeline(run, find("rows"), find("chart"), find("axis"));
const state = {time: 0, playing: false, speed: 1, robot: run.robots[0] ?? null};
const options = {trails: true, sketches: true, names: true};
const kMostChips = 6, kMostListed = 400;
// A page of several runs shows each in a frame, which names it; the address is that of the page.
const shown = window.frameElement?.dataset.run, home = shown ? parent : window;
document.body.classList.toggle("framed", Boolean(shown));

find("from-above").src = `data:image/svg+xml,${encodeURIComponent(run.picture)}`;
let view = null;
try {
  view = new View(run, find("world"), find("notes"));
} catch (error) {
  document.body.classList.add("flat");  // the picture from above stays
}

// The legend of the fields on the floor.
const legend = run.fields.map((field) => {
  const row = element("li"), ramp = element("i");
  ramp.style.setProperty("--own", `rgb(${field.colour.join(" ")} / 85%)`);
  const name = element("span", "name", field.id), range = element("span", "range");
  row.append(name, "0", ramp, range);
  find("fields").append(row);
  return {field, row, range};
});

const seconds = (time) => `${time.toFixed(1)} s`;
let wanted = false, drawn_at = 0, slow = 0;
const draw = () => {
  if (wanted) return;
  wanted = true;
  requestAnimationFrame((now) => {
    wanted = false;
    frame(now);
  });
};

let before = 0, still = 0, fast = 0;
const frame = (now) => {
  if (state.playing) {
    const passed = Math.min((now - before) / 1000, 0.25);
    state.time = Math.min(state.time + passed * state.speed, run.end);
    if (state.time >= run.end) play(false);
    draw();
  }
  before = now;
  show();
};

const show = () => {
  if (view) {
    const from = performance.now();
    view.draw(state.time, state.robot, options);
    view.painter.gl.finish();
    // Pictures that take too long lose shadows and pixels; a picture that stands still gets them back.
    slow = 0.8 * slow + 0.2 * (performance.now() - from);
    if (slow > 45 && view.quality > 0.3) [view.quality, slow] = [view.quality - 0.35, 0];
    if (slow > 12 || view.quality === 1 || !state.playing) fast = 0;
    else if (++fast > 90) [view.quality, fast] = [Math.min(view.quality + 0.35, 1), 0];
    clearTimeout(still);
    if (view.quality < 1 && !state.playing) {
      still = setTimeout(() => {
        const before_it = view.quality;
        view.quality = 1;
        view.draw(state.time, state.robot, options);
        view.quality = before_it;
      }, 250);
    }
  }
  for (const {field, row, range} of legend) {
    const top = run.top(field, run.sample(state.time));
    row.hidden = !(top > 0);
    range.textContent = `${short(top)} per m²`;
  }
  find("fields").hidden = legend.every(({row}) => row.hidden);
  const is_there = state.robot && run.pose(state.robot.body, run.sample(state.time));
  const said = is_there ? timeline.say(state.time) : null, part = state.time / run.end;
  find("clock").textContent = state.time.toFixed(1);
  find("time").value = state.time;
  find("time").setAttribute("aria-valuetext", seconds(state.time) + (said ? `, ${said.name} decides` : ""));
  find("cursor").style.left = `${100 * part}%`;
  find("decides").hidden = !said;
  if (said) {
    find("who").textContent = said.name;
    find("who").style.setProperty("--own", said.colour || "transparent");
    find("why").textContent = said.reason;
    find("since").textContent = `since ${said.since.toFixed(2)} s`;
  }
  const latest = place_of(event_times, state.time + 1e-9);
  if (latest !== show.latest) {
    listed[show.latest]?.removeAttribute("aria-current");
    listed[latest]?.setAttribute("aria-current", "true");
    const row = listed[latest], list = find("events");
    if (row && !list.matches(":hover")) list.scrollTop = row.parentElement.offsetTop - list.clientHeight / 2;
    show.latest = latest;
  }
};

const write_link = () => {
  const link = new URLSearchParams(shown ? {run: shown} : {});
  link.set("t", String(Number(state.time.toFixed(2))));
  if (state.robot) link.set("robot", state.robot.id);
  try {
    home.history.replaceState(null, "", `#${link}`);
  } catch {
    // In a frame of another page there is no address to change.
  }
};
const read_link = () => {
  const link = new URLSearchParams(home.location.hash.slice(1)), time = Number(link.get("t"));
  if (shown && link.get("run") !== shown) return;
  const robot = run.robots.find((each) => each.id === link.get("robot"));
  if (robot) choose(robot, false);
  if (link.has("t") && Number.isFinite(time)) seek(time, false);
};

const seek = (time, writes = true) => {
  state.time = Math.min(Math.max(time, 0), run.end);
  if (writes && !state.playing) write_link();
  draw();
};
const play = (yes) => {
  if (yes && state.time >= run.end) state.time = 0;
  state.playing = yes;
  before = performance.now();
  const button = find("play");
  button.setAttribute("aria-label", yes ? "Pause" : "Play");
  button.classList.toggle("on", yes);
  if (!yes) write_link();
  draw();
};
const choose = (robot, writes = true) => {
  state.robot = robot;
  timeline.show(robot);
  const team = robot?.team ? `team ${robot.team}` : "";
  const own = robot && run.decided(robot.id, state.time);
  const coordinator = own?.bands.find((band) => band.parent < 0)?.coordinator ?? "";
  find("robot-name").textContent = robot?.id ?? "no robot";
  find("robot-name").style.setProperty("--own", robot ? `rgb(${robot.colour.join(" ")})` : "transparent");
  find("robot-facts").textContent = [team, coordinator].filter(Boolean).join(" · ");
  for (const chip of find("robots").querySelectorAll("button")) chip.setAttribute("aria-pressed", String(chip.value === robot?.id));
  const box = find("robots").querySelector("select");
  if (box && robot) box.value = robot.id;
  if (writes) write_link();
  draw();
};

// Robots: buttons, or a list where there are many.
if (run.robots.length > kMostChips) {
  const box = element("select");
  box.setAttribute("aria-label", "Robot");
  for (const robot of run.robots) {
    const item = element("option", "", robot.id);
    item.value = robot.id;
    box.append(item);
  }
  box.addEventListener("change", () => choose(run.robots[box.selectedIndex]));
  find("robots").append(box);
} else {
  for (const robot of run.robots) {
    const chip = element("button", "chip", robot.id);
    chip.type = "button";
    chip.value = robot.id;
    chip.style.setProperty("--own", `rgb(${robot.colour.join(" ")})`);
    chip.addEventListener("click", () => choose(robot));
    find("robots").append(chip);
  }
}

// Events: the first ones as a list; the time line has all.
const event_times = run.events.map((event) => event.time);
const listed = run.events.slice(0, kMostListed).map((event) => {
  const row = element("button", event.bad ? "bad" : "");
  row.type = "button";
  const what = element("span", "what", event.name.replaceAll("_", " "));
  const about = [run.robots.length > 1 ? event.robot : "", event.detail].filter(Boolean).join(" · ");
  if (about) what.append(element("small", "", about));
  row.append(element("time", "", event.time.toFixed(2)), what);
  row.addEventListener("click", () => {
    const robot = run.robots.find((each) => each.id === event.robot);
    if (robot && robot !== state.robot) choose(robot, false);
    seek(event.time);
  });
  const item = element("li");
  item.append(row);
  find("events").append(item);
  return row;
});
find("no-events").hidden = run.events.length > 0 && run.events.length <= kMostListed;
if (run.events.length > kMostListed) {
  find("no-events").textContent = `The first ${kMostListed} of ${run.events.length} events; the time line shows all.`;
}

const slider = find("time");
slider.max = run.end;
slider.addEventListener("input", () => seek(Number(slider.value)));
find("whole").textContent = run.end.toFixed(1);
find("play").addEventListener("click", () => play(!state.playing));
find("speed").addEventListener("change", (event) => (state.speed = Number(event.target.value)));
find("link").addEventListener("click", async () => {
  write_link();
  const said = find("link-said");
  try {
    await navigator.clipboard.writeText(home.location.href);
    said.textContent = "copied";
  } catch {
    said.textContent = "the address has it";
  }
  setTimeout(() => (said.textContent = ""), 2000);
});

// The time line is a second handle for the time.
const tracks = find("tracks");
const scrub = (event) => {
  const box = find("chart").getBoundingClientRect();
  seek(((event.clientX - box.left) / box.width) * run.end);
};
tracks.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  tracks.setPointerCapture(event.pointerId);
  scrub(event);
});
tracks.addEventListener("pointermove", (event) => {
  if (tracks.hasPointerCapture(event.pointerId)) scrub(event);
});

const commands = {
  overview: () => view?.overview(),
  top: () => view?.overview(Math.PI / 2),
  follow: () => view?.follow(),
};
for (const [name, act] of Object.entries(commands)) {
  find(name).addEventListener("click", () => {
    act();
    draw();
  });
}
for (const name of Object.keys(options)) {
  find(name).addEventListener("click", () => {
    options[name] = !options[name];
    find(name).setAttribute("aria-pressed", String(options[name]));
    draw();
  });
}
view?.handle(draw, choose);

// What was pressed by a pointer does not keep the keys to itself.
let is_pointer = false;
addEventListener("pointerdown", () => (is_pointer = true), true);
addEventListener("keydown", () => (is_pointer = false), true);
for (const kind of ["click", "change"]) {
  document.addEventListener(kind, ({target}) => {
    if (is_pointer && ["BUTTON", "SUMMARY", "SELECT"].includes(target.tagName) && (kind === "change") === (target.tagName === "SELECT")) target.blur();
  });
}

const neighbour = (way) => {
  const all = way > 0 ? run.events : [...run.events].reverse();
  const next = all.find((event) => way * (event.time - state.time) > 1e-3);
  if (next) seek(next.time);
};
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  const large = event.shiftKey ? 10 : 1;
  const acts = {
    " ": () => play(!state.playing),
    ArrowLeft: () => seek(state.time - 0.1 * large * Math.max(1, run.end / 100)),
    ArrowRight: () => seek(state.time + 0.1 * large * Math.max(1, run.end / 100)),
    Home: () => seek(0),
    End: () => seek(run.end),
    ",": () => neighbour(-1),
    ".": () => neighbour(1),
    o: commands.overview,
    t: commands.top,
    f: commands.follow,
  };
  if (event.key === " " && ["BUTTON", "SUMMARY"].includes(event.target.tagName)) return;
  const digit = /^[1-9]$/.test(event.key) ? run.robots[Number(event.key) - 1] : null;
  const act = digit ? () => choose(digit) : acts[event.key];
  if (!act) return;
  event.preventDefault();
  act();
  draw();
});

const redraw = () => {
  view?.theme();
  timeline.show(state.robot);
  draw();
};
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
matchMedia("print").addEventListener("change", redraw);
addEventListener("beforeprint", () => (find("about").open = true));
new ResizeObserver(() => {
  timeline.draw();
  draw();
}).observe(document.body);
find("world").addEventListener("webglcontextlost", () => document.body.classList.add("flat"));
home.addEventListener("hashchange", read_link);

choose(state.robot, false);
read_link();
draw();

// For other scripts, and for tests: the instant, where places are in the picture, and the colours there.
window.elsie = {
  run,
  get time() {
    return state.time;
  },
  get robot() {
    return state.robot?.id ?? null;
  },
  get playing() {
    return state.playing;
  },
  get shows_space() {
    return view !== null;
  },
  seek(time) {
    seek(time);
    show();
  },
  play,
  pose: (id) => run.pose(run.robots.find((robot) => robot.id === id)?.body ?? -1, run.sample(state.time)),
  project: (place) => view.project(place)?.slice(0, 2) ?? null,
  pixel(place) {
    show();
    const at = view.project(place);
    return at && view.painter.pixel(at[0] * view.ratio, at[1] * view.ratio);
  },
};
