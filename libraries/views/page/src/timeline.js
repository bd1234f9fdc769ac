// The time line of a robot: events, who decided, shares of behaviours, published numbers, over one axis of time.
const tick_step = (range, most) => {
  const raw = range / most, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((each) => each * power >= raw * (1 - 1e-9));
};
const short = (value) => String(Number(value.toPrecision(4)));
const element = (name, className, text) => {
  const made = document.createElement(name);
  if (className) made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
};

const kNobody = -1, kTogether = -2;
const kHeights = {events: 30, band: 24, share: 24, number: 44};

class Timeline {
  constructor(run, rows, canvas, head) {
    this.run = run;
    this.rows = rows;
    this.canvas = canvas;
    this.head = head;
    this.list = [];
  }

  show(robot) {
    this.robot = robot;
    this.dark = getComputedStyle(document.documentElement).getPropertyValue("--scheme").trim() === "dark";
    const name = robot?.id ?? "", own = this.run.decisions.filter((each) => each.robot === name);
    this.list = [{kind: "events", name: "events", events: this.run.events}];
    const members = new Map();  // by path; edits of a run may change them
    for (const part of own) {
      for (const band of part.bands) {
        const where = band.parent < 0 ? "" : part.members[band.parent].path;
        const known = this.list.find((row) => row.kind === "band" && row.where === where);
        if (known) known.parts.push([part, band]);
        else this.list.push({kind: "band", where, name: where ? `in ${where}` : "decides", parts: [[part, band]]});
      }
      part.members.forEach((member, i) => {
        if (!members.has(member.path)) members.set(member.path, {kind: "share", name: member.path.split("/").pop(), member, parts: []});
        members.get(member.path).parts.push([part, i]);
      });
    }
    this.list.push(...members.values());
    for (const number of this.run.numbers) {
      if (number.robot === name) this.list.push({kind: "number", name: number.name, number});
    }
    this.rows.replaceChildren(
      ...this.list.map((row) => {
        const line = element("div", `row ${row.kind}`);
        line.style.height = `${kHeights[row.kind]}px`;
        if (row.kind === "share") {
          const swatch = element("i", "swatch");
          swatch.style.background = this.visible(row.member.colour);
          line.style.paddingLeft = `${8 + 12 * row.member.depth}px`;
          line.append(swatch);
        }
        const title = element("span", "name", row.kind === "number" ? row.name.split("/").pop() : row.name);
        const whose = row.kind === "number" && row.name.split("/").slice(0, -1).join("/");
        if (whose) title.prepend(element("small", "", whose));
        title.title = row.member ? this.explain(row) : row.name;
        row.now = element("span", "value");
        line.append(title, row.now);
        return line;
      }),
    );
    this.describe(own);
    this.draw();
  }

  explain({member, parts}) {
    const plugin = member.plugin ? ` (${member.plugin})` : "";
    return member.path + plugin + (parts[0][0].of === "time" ? ": part of the time in which it decided" : "");
  }

  // For readers who do not see it.
  describe(own) {
    const times = new Map();
    let whole = 0;
    for (const part of own) {
      const band = part.bands.find((each) => each.parent < 0);
      band?.t.forEach((from, i) => {
        const length = (band.t[i + 1] ?? part.to) - from, who = band.who[i];
        const name = who >= 0 ? part.members[who].path : who === kTogether ? "several" : "nobody";
        times.set(name, (times.get(name) ?? 0) + length);
        whole += length;
      });
    }
    const said = [...times].sort((a, b) => b[1] - a[1]).map(([name, time]) => `${name} ${Math.round((100 * time) / whole)} %`);
    this.canvas.setAttribute("aria-label", said.length ? `Who decided: ${said.join(", ")}.` : "Time line of events.");
  }

  // A behaviour's colour, as bright as a dark page needs.
  visible(hex) {
    const parts = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
    const light = 0.3 * parts[0] + 0.59 * parts[1] + 0.11 * parts[2];
    if (!this.dark || light > 95) return hex;
    return `rgb(${parts.map((each) => Math.round(each + 0.42 * (255 - each))).join(" ")})`;
  }

  x_of(time) {
    return (time / this.run.end) * this.width;
  }

  draw() {
    const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
    const height = this.list.reduce((sum, row) => sum + kHeights[row.kind], 0), ratio = Math.min(devicePixelRatio || 1, 3);
    this.width = Math.max(this.canvas.parentElement.clientWidth, 1);
    this.canvas.style.height = `${height}px`;
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const pen = this.canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, this.width, height);
    this.axis(pen, height, colour);
    let y = 0;
    for (const row of this.list) {
      const own = kHeights[row.kind];
      if (row.kind === "events") this.events(pen, y, own, colour);
      if (row.kind === "band") for (const [part, band] of row.parts) this.band(pen, part, band, y + 4, own - 8, colour);
      if (row.kind === "share") for (const [part, i] of row.parts) this.share(pen, part, i, y + 3, own - 6);
      if (row.kind === "number") this.number(pen, row.number, y + 6, own - 12, colour);
      y += own;
      pen.fillStyle = colour("--hair");
      pen.fillRect(0, y - 0.5, this.width, 1);
    }
  }

  axis(pen, height, colour) {
    const step = tick_step(this.run.end, Math.max(3, Math.floor(this.width / 90)));
    pen.fillStyle = colour("--hair");
    const labels = [];
    for (let i = 0; i * step <= this.run.end * (1 + 1e-9); ++i) {
      const x = this.x_of(i * step);
      pen.fillRect(x - 0.5, 0, 1, height);
      const label = element("span", "tick", short(i * step) + (i === 0 ? " s" : ""));
      label.style.left = `${(100 * i * step) / this.run.end}%`;
      if (x < this.width - 24) labels.push(label);
    }
    this.head.replaceChildren(...labels);
  }

  events(pen, y, height, colour) {
    const own = this.run.events.filter((event) => event.robot === this.robot?.id || event.robot === "");
    const others = this.run.events.filter((event) => event.robot !== this.robot?.id && event.robot !== "");
    for (const [list, strength] of [[others, 0.28], [own, 1]]) {
      for (const bad of [0, 1]) {
        pen.globalAlpha = strength;
        pen.fillStyle = pen.strokeStyle = colour(bad ? "--bad" : "--accent");
        for (const event of list) {
          if (event.bad !== bad) continue;
          const x = Math.min(Math.max(this.x_of(event.time), 5), this.width - 5), middle = y + height / 2;
          pen.beginPath();
          if (bad) {
            pen.moveTo(x, middle - 5);
            pen.lineTo(x + 4.6, middle + 4);
            pen.lineTo(x - 4.6, middle + 4);
          } else {
            pen.arc(x, middle, 3.6, 0, 7);
          }
          pen.fill();
        }
      }
    }
    pen.globalAlpha = 1;
  }

  // Calls `see` for each pixel from left to right with the parts of its time: [index, seconds].
  columns(times, from, to, see) {
    const last = Math.min(Math.ceil(this.x_of(to)), Math.ceil(this.width));
    let i = Math.max(0, place_of(times, from));
    for (let x = Math.floor(this.x_of(from)); x < last; ++x) {
      const begin = Math.max((x / this.width) * this.run.end, from), end = Math.min(((x + 1) / this.width) * this.run.end, to), parts = [];
      while (i < times.length && times[i] < end) {
        const length = Math.min(times[i + 1] ?? to, end) - Math.max(times[i], begin);
        if (length > 0) parts.push([i, length]);
        if ((times[i + 1] ?? Infinity) > end) break;
        ++i;
      }
      if (parts.length) see(x, parts);
    }
  }

  // Several deciders in one pixel share its height, as in the picture of the time line.
  band(pen, part, band, y, height, colour) {
    this.columns(band.t, part.from, part.to, (x, parts) => {
      const times = new Map();
      let whole = 0;
      for (const [i, length] of parts) {
        times.set(band.who[i], (times.get(band.who[i]) ?? 0) + length);
        whole += length;
      }
      let top = y;
      for (const [who, length] of [...times].sort((a, b) => a[0] - b[0])) {
        const own = (height * length) / whole;
        if (who >= 0 || who === kTogether) {
          pen.fillStyle = who >= 0 ? this.visible(part.members[who].colour) : colour("--together");
          pen.fillRect(x, top, 1, own);
        }
        top += own;
      }
    });
  }

  share(pen, part, member, y, height) {
    pen.fillStyle = this.visible(part.members[member].colour);
    pen.globalAlpha = 0.78;
    this.columns(part.t, part.from, part.to, (x, parts) => {
      let sum = 0, whole = 0;
      for (const [i, length] of parts) {
        sum += length * part.shares[member][i];
        whole += length;
      }
      const own = (height * sum) / whole / 100;
      if (own > 0.05) pen.fillRect(x, y + height - own, 1, own);
    });
    pen.globalAlpha = 1;
  }

  number(pen, number, y, height, colour) {
    let low = Infinity, high = -Infinity;
    number.v.forEach((value, i) => {
      if (number.none.has(i)) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    });
    const span = high - low || 1;
    pen.strokeStyle = colour("--accent");
    pen.lineWidth = 1.3;
    pen.beginPath();
    let drawn = false;
    number.v.forEach((value, i) => {
      if (number.none.has(i)) return void (drawn = false);
      const [x, at] = [this.x_of(number.t[i]), y + height - (height * (value - low)) / span];
      if (drawn) pen.lineTo(x, at);
      else pen.moveTo(x, at);
      drawn = true;
    });
    pen.stroke();
    pen.fillStyle = colour("--muted");
    pen.font = `10px ${colour("--font")}`;
    pen.textAlign = "right";
    const near_zero = (value) => (Math.abs(value) < 1e-3 * span ? 0 : value);
    pen.fillText(short(near_zero(high)), this.width - 3, y + 8);
    if (high > low) pen.fillText(short(near_zero(low)), this.width - 3, y + height);
  }

  // Writes what holds at a time beside the rows; returns who decides, and why.
  say(time) {
    let said = null;
    for (const row of this.list) {
      let text = "";
      const at = row.parts?.find(([part]) => time <= part.to) ?? row.parts?.[row.parts.length - 1];
      if (row.kind === "band" && at) {
        const [part, band] = at, i = place_of(band.t, time + 1e-9), who = i < 0 ? kNobody : band.who[i];
        const name = who >= 0 ? part.members[who].path.split("/").pop() : who === kTogether ? "several" : "nobody";
        if (!row.where) {
          const since = i < 0 ? 0 : band.t[i];
          said = {name, since, reason: who >= 0 ? this.run.reasons[band.why[i]] : "", colour: who >= 0 ? this.visible(part.members[who].colour) : ""};
        } else {
          text = who >= 0 ? name : "";
        }
      } else if (row.kind === "share" && at) {
        const [part, i] = at, k = place_of(part.t, time + 1e-9);
        text = `${k < 0 ? 0 : part.shares[i][k]} %`;
      } else if (row.kind === "number") {
        const {t, v, none, unit} = row.number, k = place_of(t, time + 1e-9);
        text = k < 0 || none.has(k) ? "–" : short(v[k]) + (unit ? ` ${unit}` : "");
      }
      if (row.now.textContent !== text) row.now.textContent = text;
    }
    return said;
  }
}

