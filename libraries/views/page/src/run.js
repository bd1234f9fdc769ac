// The run: what the data say, and where everything is at a time.
const bytes_of = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

const sums = (differences, scale = 1) => {
  let sum = 0;
  return Float64Array.from(differences, (difference) => (sum += difference) * scale);
};

// The last place in an ascending list whose number is at most this one; -1: there is none.
const place_of = (list, number) => {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] <= number) low = middle + 1;
    else high = middle;
  }
  return low - 1;
};

class Run {
  constructor(data) {
    const fine = 1e-4;  // s, m and rad
    this.end = Math.max(data.end * fine, 1e-3);
    this.times = sums(data.times, fine);
    this.every = data.poses.every;
    this.bodies = data.poses.bodies.map((body) => ({
      s: sums(body.s),
      x: sums(body.x, fine),
      y: sums(body.y, fine),
      h: sums(body.h, fine),
      set: new Set(body.set),
      gone: new Set(body.gone),
    }));
    this.picture = data.picture;
    this.scenes = data.scenes;
    this.images = data.images;
    this.roles = data.roles;
    this.lights = data.lights.map((each) => ({...each, s: sums(each.s)}));
    this.sketches = data.sketches.map((each) => ({...each, s: sums(each.s)}));
    this.fields = data.fields.map((each) => ({...each, s: sums(each.s), tops: {...each.tops, s: sums(each.tops.s)}}));
    this.reasons = data.reasons;
    this.decisions = data.decisions.map((each) => ({
      ...each,
      from: each.from * fine,
      to: Math.min(each.to * fine, this.end),
      t: sums(each.t, fine),
      shares: each.shares.map((shares) => sums(shares)),
      bands: each.bands.map((band) => ({...band, t: sums(band.t, fine)})),
    }));
    this.numbers = data.numbers.map((each) => ({
      ...each,
      t: sums(each.t, fine),
      v: sums(each.v).map((value) => each.low + value * each.step),
      none: new Set(each.none),
    }));
    this.events = data.events.map(([time, robot, name, detail, bad]) => ({time: time * fine, robot, name, detail, bad}));
    // Every robot that is there at some time, as it is first described.
    const known = new Map();
    for (const robot of this.scenes.flatMap((scene) => scene.robots)) {
      if (!known.has(robot.body)) known.set(robot.body, robot);
    }
    this.robots = [...known.values()];
  }

  // The number of the sample at a time, with the part of the way to the next one.
  sample(time) {
    const i = Math.max(0, place_of(this.times, time + 1e-9)), next = this.times[i + 1];
    return next === undefined ? i : i + Math.min(1, Math.max(0, time - this.times[i]) / (next - this.times[i]));
  }

  scene(sample) {
    let shown = this.scenes[0];
    for (const scene of this.scenes) if (scene.from <= sample) shown = scene;
    return shown;
  }

  // Where a body is; null: nowhere.
  pose(body, sample) {
    const keys = this.bodies[body];
    const k = keys ? place_of(keys.s, sample) : -1;
    if (k < 0 || keys.gone.has(k)) return null;
    const next = k + 1;
    let part = 0;
    if (next < keys.s.length && !keys.set.has(next) && !keys.gone.has(next)) {
      const from = Math.max(keys.s[k], keys.s[next] - this.every);
      part = Math.max(0, (sample - from) / (keys.s[next] - from));
    }
    const mix = (list) => (part > 0 ? list[k] + part * (list[next] - list[k]) : list[k]);
    return {x: mix(keys.x), y: mix(keys.y), h: mix(keys.h)};
  }

  // The marks that plugins draw, in the world.
  marks(sample) {
    const found = [];
    for (const {body, s, marks, texts} of this.sketches) {
      const k = place_of(s, sample + 1e-6), pose = body < 0 ? {x: 0, y: 0, h: 0} : this.pose(body, sample);
      if (k < 0 || !pose) continue;
      const c = Math.cos(pose.h), si = Math.sin(pose.h), list = marks[k];
      let text = 0;
      for (let i = 0; i < list.length;) {
        const mark = {body, kind: list[i] >> 3, role: list[i] & 7, places: []};
        const count = list[i + 1];
        i += 2;
        for (let n = 0; n < count; ++n, i += 3) {
          const x = list[i] / 1e3, y = list[i + 1] / 1e3;
          mark.places.push([pose.x + c * x - si * y, pose.y + si * x + c * y, list[i + 2] / 1e3]);
        }
        if (mark.kind === 3) mark.text = texts[k][text++];
        found.push(mark);
      }
    }
    return found;
  }

  shines(sample) {
    const found = [];
    for (const {body, s, of} of this.lights) {
      const k = place_of(s, sample + 1e-6), pose = this.pose(body, sample);
      if (k < 0 || !pose) continue;
      const c = Math.cos(pose.h), si = Math.sin(pose.h);
      for (let i = 0; i < of[k].length; i += 5) {
        const [x, y, ...colour] = of[k].slice(i, i + 5);
        found.push({body, x: pose.x + (c * x - si * y) * 1e-4, y: pose.y + (si * x + c * y) * 1e-4, colour});
      }
    }
    return found;
  }

  // The value at which a field is drawn solid at a time, units/m2; 0: there is nothing of it.
  top({tops}, sample) {
    return tops.v[place_of(tops.s, sample + 1e-6)] ?? 0;
  }

  // The decisions of a robot at a time; null: nobody recorded them.
  decided(robot, time) {
    const own = this.decisions.filter((each) => each.robot === robot);
    return own.find((each) => time <= each.to) ?? own[own.length - 1] ?? null;
  }
}

