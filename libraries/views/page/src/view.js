// The picture of the world: what the painter draws at a time, the notes above it, and the camera in the user's hands.
const kMostNames = 40, kMostTrails = 60;
const kCurve = -1;  // in place of dashes: a part of a curve

// The product of the body's pose and a piece's frame, as rows, with the piece's size; then its colour.
const place_solid = (out, pose, f, [sx, sy, sz], colour, shine = 0) => {
  const c = pose ? Math.cos(pose.h) : 1, s = pose ? Math.sin(pose.h) : 0, x = pose ? pose.x : 0, y = pose ? pose.y : 0;
  out.push(
    (c * f[0] - s * f[1]) * sx, (c * f[3] - s * f[4]) * sy, (c * f[6] - s * f[7]) * sz, c * f[9] - s * f[10] + x,
    (s * f[0] + c * f[1]) * sx, (s * f[3] + c * f[4]) * sy, (s * f[6] + c * f[7]) * sz, s * f[9] + c * f[10] + y,
    f[2] * sx, f[5] * sy, f[8] * sz, f[11],
    colour[0] / 255, colour[1] / 255, colour[2] / 255, shine,
  );
};
const kUpright = [1, 0, 0, 0, 1, 0, 0, 0, 1];

class View {
  constructor(run, canvas, notes) {
    this.run = run;
    this.canvas = canvas;
    this.notes = notes.getContext("2d");
    this.painter = new Painter(canvas);
    this.camera = new Camera();
    this.quality = 1;
    const mesh = (make) => this.painter.upload(make);
    this.box = mesh(new Mesh().prism([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]], 0, 1));
    this.cylinder = mesh(new Mesh().cylinder(36));
    this.ball = mesh(new Mesh().ball(20));
    // The front of a robot: an arrow on its deck.
    const arrow = new Mesh();
    arrow.triangle([0.5, 0, 0], [-0.34, 0.36, 0], [-0.16, 0, 0], [0, 0, 1]);
    arrow.triangle([0.5, 0, 0], [-0.16, 0, 0], [-0.34, -0.36, 0], [0, 0, 1]);
    this.arrow = mesh(arrow);
    this.prisms = new Map();
    this.sheets = new Map();  // of scenes
    this.fields = new Map();
    this.following = false;
    this.first = true;
    this.theme();
  }

  theme() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => {
      const hex = style.getPropertyValue(name).trim();
      return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
    };
    this.room = colour("--room");
    this.ground = colour("--floor");
    this.lines = colour("--lines");
    this.dim = Number(style.getPropertyValue("--dim")) || 1;
    this.still = Number(style.getPropertyValue("--still")) || 1;  // of walls and what else never moves
    this.ink = style.getPropertyValue("--ink");
    this.muted = style.getPropertyValue("--muted");
    this.halo = style.getPropertyValue("--halo");
    this.font = style.getPropertyValue("--font");
  }

  resize() {
    const ratio = Math.min(devicePixelRatio || 1, 2) * (this.quality < 0.6 ? 0.5 : 1);
    const {clientWidth: width, clientHeight: height} = this.canvas;
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
    const pixels = [Math.round(this.width * ratio), Math.round(this.height * ratio)];
    if (this.canvas.width !== pixels[0] || this.canvas.height !== pixels[1]) [this.canvas.width, this.canvas.height] = pixels;
    this.ratio = ratio;
    const sharp = Math.min(devicePixelRatio || 1, 3), own = this.notes.canvas;
    own.width = Math.round(this.width * sharp);
    own.height = Math.round(this.height * sharp);
    this.notes.setTransform(sharp, 0, 0, sharp, 0, 0);
  }

  overview(over) {
    const {arena, walls} = this.run.scene(this.sample ?? 0);
    this.following = false;
    this.camera.show(arena[0], arena[1], walls, [this.width, this.height], over);
  }

  follow() {
    this.following = true;
    this.close = true;
  }

  // The camera stays where it is.
  leave() {
    this.following = false;
    this.camera.turn(0, 0);
  }

  // Raises the camera until it sees a place over walls and obstacles. It rises at once, and sinks bit by bit.
  rise(scene, place) {
    const camera = this.camera;
    camera.raised *= 0.85;
    while (camera.over + camera.raised < Math.PI / 2 && this.is_hidden(scene, place, camera.eye())) camera.raised += 0.02;
  }

  // Whether a box that is not a robot's is between two places.
  is_hidden(scene, a, b) {
    const robots = new Set(this.run.robots.map((robot) => robot.body));
    return scene.boxes.some(({body, frame, size}) => {
      const pose = body < 0 ? {x: 0, y: 0, h: 0} : this.run.pose(body, this.sample);
      if (!pose || robots.has(body)) return false;
      const c = Math.cos(pose.h), s = Math.sin(pose.h);
      const within = ([x, y, z]) => [c * (x - pose.x) + s * (y - pose.y) - frame[9], c * (y - pose.y) - s * (x - pose.x) - frame[10], z - frame[11]];
      const from = within(a), to = within(b);
      let enters = 0, leaves = 1;  // of the way from one to the other
      for (let i = 0; i < 3; ++i) {
        const axis = frame.slice(3 * i, 3 * i + 3), at = inner(from, axis), per = inner(to, axis) - at;
        const low = i < 2 ? -size[i] / 2 : 0, high = low + size[i];  // the frame is that of its foot
        const ends = [(low - at) / per, (high - at) / per];
        if (Math.abs(per) > 1e-9) [enters, leaves] = [Math.max(enters, Math.min(...ends)), Math.min(leaves, Math.max(...ends))];
        else if (at < low || at > high) return false;
      }
      return enters < leaves;
    });
  }

  // Where a place is in the picture, in CSS pixels; null: behind the eye.
  project(p) {
    const [x, y, w] = this.camera.clip(this.matrix, p);
    return w > 1e-6 ? [(0.5 + (0.5 * x) / w) * this.width, (0.5 - (0.5 * y) / w) * this.height, w] : null;
  }

  solids(scene, selected) {
    const boxes = [], cylinders = [], balls = [], arrows = [], groups = [];
    const each = (pieces, out, size_of) => {
      for (const {body, frame, size, colour} of pieces) {
        const pose = body < 0 ? null : this.run.pose(body, this.sample);
        if (body < 0 || pose) place_solid(out, pose, frame, size_of(size), body < 0 ? colour.map((each) => each * this.still) : colour);
      }
    };
    each(scene.boxes, boxes, (size) => size);
    each(scene.cylinders, cylinders, ([radius, length]) => [radius, length, radius]);
    each(scene.balls, balls, (radius) => [radius, radius, radius]);
    for (const piece of scene.prisms) {
      const numbers = [];
      each([piece], numbers, ([height]) => [1, 1, height]);
      groups.push({mesh: this.prism(piece.size[1]), numbers: new Float32Array(numbers)});
    }
    for (const {body, size, middle, deck, colour} of scene.robots) {
      const pose = this.run.pose(body, this.sample);
      if (!pose) continue;
      const length = 0.62 * Math.min(size[0], size[1]), light = 0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2] > 150;
      const ink = light ? [40, 44, 50] : [255, 255, 255];
      place_solid(arrows, pose, [...kUpright, ...middle, deck + 0.004 * length + 5e-4], [length, length, 1], ink, 0.6);
    }
    for (const {body, x, y, colour} of this.run.shines(this.sample)) {
      const robot = scene.robots.find((each) => each.body === body);
      if (!robot) continue;
      const radius = 0.09 * Math.min(robot.size[0], robot.size[1]);
      place_solid(balls, null, [...kUpright, x, y, robot.top + radius], [radius, radius, radius], colour, 1);
    }
    const group = (mesh, numbers) => ({mesh, numbers: new Float32Array(numbers)});
    return [...groups, group(this.box, boxes), group(this.cylinder, cylinders), group(this.ball, balls), group(this.arrow, arrows)];
  }

  prism(outline) {
    if (!this.prisms.has(outline)) this.prisms.set(outline, this.painter.upload(new Mesh().prism(outline, 0, 1)));
    return this.prisms.get(outline);
  }

  // What lies on the floor: image, patches, marks, fields.
  floor(scene) {
    if (!this.sheets.has(scene)) {
      const sheets = [], flat = [];
      const polygon = (outline, colour, alpha = 1) => {
        const tint = [...colour.map((each) => each / 255), alpha];
        for (let i = 2; i < outline.length; ++i) {
          for (const [x, y] of [outline[0], outline[i - 1], outline[i]]) flat.push(x, y, 0, ...tint);
        }
      };
      const disc = (at, radius, colour, alpha) =>
        polygon(Array.from({length: 48}, (_, i) => [at[0] + radius * Math.cos((i * Math.PI) / 24),
                                                    at[1] + radius * Math.sin((i * Math.PI) / 24)]), colour, alpha);
      for (const {outline, colour} of scene.patches) polygon(outline, colour);
      for (const {at, radius, colour} of scene.marks) disc(at, radius, colour, 0.75);
      if (scene.image) {
        const image = new Image(), sheet = {size: scene.image.size, corners: this.rectangle(...scene.image.size)};
        sheets.push(sheet);
        image.onload = () => {
          sheet.texture = this.painter.image_texture(image);
          this.changed?.();
        };
        image.src = this.run.images[scene.image.png];
      }
      if (flat.length) sheets.push({corners: new Float32Array(flat)});
      this.sheets.set(scene, sheets);
    }
    const shown = this.sheets.get(scene).filter((sheet) => sheet.texture || !sheet.size);
    for (const field of this.run.fields) {
      const k = place_of(field.s, this.sample + 1e-6);
      if (k < 0) continue;
      const known = this.fields.get(field.id);
      if (known?.k !== k) {
        if (known) this.painter.gl.deleteTexture(known.texture);
        const cells = bytes_of(field.cells[k]), columns = field.columns[k], rows = cells.length / columns;
        const pixels = new Uint8Array(4 * cells.length);
        for (let row = 0; row < rows; ++row) {
          for (let column = 0; column < columns; ++column) {
            pixels.set([...field.colour, cells[(rows - 1 - row) * columns + column]], 4 * (row * columns + column));
          }
        }
        this.fields.set(field.id, {k, texture: this.painter.texture(columns, rows, pixels)});
      }
      shown.push({texture: this.fields.get(field.id).texture, corners: this.rectangle(...scene.arena), size: scene.arena});
    }
    return shown;
  }

  rectangle(length, width) {
    const x = length / 2, y = width / 2;
    return new Float32Array([[-x, -y], [x, -y], [x, y], [-x, -y], [x, y], [-x, y]].flatMap(([a, b]) => [a, b, 0, 1, 1, 1, 1]));
  }

  segments(scene, selected, options) {
    const out = [];
    const line = (a, b, [red, green, blue], alpha, width, dashes = 0) =>
      out.push(...a, ...b, red / 255, green / 255, blue / 255, alpha, width * this.ratio, dashes * this.ratio);
    const ring = (x, y, radius, colour, alpha, width) => {
      const sides = 40;
      for (let i = 0; i < sides; ++i) {
        const [a, b] = [i, i + 1].map((k) => [x + radius * Math.cos((2 * Math.PI * k) / sides), y + radius * Math.sin((2 * Math.PI * k) / sides), 0.004]);
        line(a, b, colour, alpha, width, kCurve);
      }
    };
    const lift = 0.003;
    for (const {at, radius} of scene.places) ring(at[0], at[1], radius, [0x00, 0x8c, 0x66], 0.9, 2);
    for (const robot of this.run.robots) {
      const is_chosen = robot === selected, many = this.run.robots.length > kMostTrails;
      if (options.trails && (is_chosen || !many)) this.trail(robot, is_chosen, line, lift);
      const pose = this.run.pose(robot.body, this.sample);
      if (!pose) continue;
      // Small robots get a ring as large as a finger's tip.
      const radius = 0.5 * Math.hypot(robot.size[0], robot.size[1]), at = this.project([pose.x, pose.y, 0]);
      if (!at) continue;
      const pixels = (radius * this.height) / (2 * Math.tan(kFieldOfView / 2) * at[2]);
      const least = 11, is_small = pixels < least && this.run.robots.length <= kMostTrails;
      if (is_chosen) ring(pose.x, pose.y, radius * Math.max(1.35, (least + 3) / pixels), robot.colour, 0.95, 2.4);
      else if (is_small) ring(pose.x, pose.y, (radius * least) / pixels, robot.colour, 0.6, 1.4);
    }
    if (options.sketches) {
      const all = this.run.robots.length <= 12;
      for (const mark of this.marks) {
        if (!all && mark.body >= 0 && mark.body !== selected?.body) continue;
        const [colour, alpha, width, dashes] = this.run.roles[mark.role], strength = mark.body < 0 || mark.body === selected?.body ? alpha : alpha * 0.6;
        const places = mark.places;
        if (mark.kind === 0) {
          for (const at of places) line(at, at, colour, strength, 5);
        } else if (mark.kind === 1 || mark.kind === 2) {
          for (let i = 1; i < places.length; ++i) line(places[i - 1], places[i], colour, strength, width, dashes);
        }
        if (mark.kind === 2) {
          const [a, b] = places, way = [b[0] - a[0], b[1] - a[1], b[2] - a[2]], size = Math.min(0.25 * Math.hypot(...way), 0.12);
          const [dx, dy] = unit([way[0], way[1], 0]);
          for (const side of [1, -1]) line(b, [b[0] - size * (dx - 0.55 * side * dy), b[1] - size * (dy + 0.55 * side * dx), b[2]], colour, strength, width);
        }
      }
    }
    return new Float32Array(out);
  }

  trail(robot, is_chosen, line, lift) {
    const keys = this.run.bodies[robot.body];
    if (!keys) return;
    const last = place_of(keys.s, this.sample), strength = is_chosen ? 0.9 : 0.5, width = is_chosen ? 2.2 : 1.6;
    const colour = robot.colour.map((each, i) => strength * each + (1 - strength) * 255 * this.ground[i]);
    let [x, y] = [keys.x[0], keys.y[0]], before = 0;
    const to = (nx, ny) => {
      const way = Math.atan2(ny - y, nx - x);
      line([x, y, lift], [nx, ny, lift], colour, 1, width, Math.cos(way - before) > 0.95 ? kCurve : 0);
      [x, y, before] = [nx, ny, way];
    };
    const apart = (1.5 * this.camera.distance) / this.height;  // m; nearer points look like one
    for (let k = 1; k <= last; ++k) {
      if (keys.set.has(k) || keys.gone.has(k)) [x, y] = [keys.x[k], keys.y[k]];
      else if (Math.abs(keys.x[k] - x) + Math.abs(keys.y[k] - y) > apart || k === last) to(keys.x[k], keys.y[k]);
    }
    const now = this.run.pose(robot.body, this.sample);
    if (now && last >= 0) to(now.x, now.y);
  }

  draw(time, selected, options) {
    this.sample = this.run.sample(time);
    const scene = this.run.scene(this.sample);
    this.resize();
    if (this.first) {
      this.overview();
      this.first = false;
    }
    const pose = selected && this.run.pose(selected.body, this.sample);
    if (this.following && pose) {
      const size = Math.hypot(...selected.size.slice(0, 2));
      if (this.close) [this.camera.distance, this.camera.over, this.close] = [9 * size, 0.42, false];
      this.camera.at = [pose.x, pose.y, 0.5 * selected.top];
      this.camera.around = pose.h + Math.PI;
      const behind = 0.3 * selected.size[0];
      this.rise(scene, [pose.x - behind * Math.cos(pose.h), pose.y - behind * Math.sin(pose.h), 0.2 * selected.top]);
    }
    this.matrix = this.camera.matrix(this.width / this.height);
    this.marks = options.sketches ? this.run.marks(this.sample) : [];
    const floor = scene.floor ? scene.floor.map((each) => each / 255) : this.ground;
    this.step = tick_step(Math.max(...scene.arena), 10);
    this.painter.draw({view: this.matrix, size: [this.canvas.width, this.canvas.height], arena: scene.arena, height: scene.walls + 0.5,
                       room: this.room, floor, lines: this.lines, step_m: this.step, dim: this.dim, shaded: this.quality > 0.3},
                      this.floor(scene), this.solids(scene, selected), this.segments(scene, selected, options));
    this.note(scene, selected, options);
  }

  // Names, the scale of the floor, and texts that plugins draw.
  note(scene, selected, options) {
    const pen = this.notes, taken = [];
    pen.clearRect(0, 0, this.width, this.height);
    pen.lineJoin = "round";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    const text = (words, x, y, size, weight, colour, needs_room = true) => {
      pen.font = `${weight} ${size}px ${this.font}`;
      const half = pen.measureText(words).width / 2 + 3;
      const box = [x - half, y - size * 0.7, x + half, y + size * 0.7];
      if (box[0] > this.width || box[2] < 0 || box[1] > this.height || box[3] < 0) return true;
      if (needs_room && taken.some((other) => box[0] < other[2] && box[2] > other[0] && box[1] < other[3] && box[3] > other[1])) return false;
      taken.push(box);
      pen.lineWidth = 3.5;
      pen.strokeStyle = this.halo;
      pen.strokeText(words, x, y);
      pen.fillStyle = colour;
      pen.fillText(words, x, y);
      return true;
    };
    const robots = this.run.robots.length <= kMostNames ? this.run.robots : selected ? [selected] : [];
    for (const robot of [...robots].sort((a, b) => (b === selected) - (a === selected))) {
      const pose = this.run.pose(robot.body, this.sample);
      const at = pose && this.project([pose.x, pose.y, robot.top]);
      if (!at || !options.names) continue;
      const half = (0.5 * Math.hypot(robot.size[0], robot.size[1]) * this.height) / (2 * Math.tan(kFieldOfView / 2) * at[2]);
      const words = robot.id.length > 24 ? robot.id.slice(0, 23) + "…" : robot.id, away = Math.max(half, 11) + 13;
      const weight = robot === selected ? 650 : 500;
      text(words, at[0], at[1] - away, 12, weight, this.ink) || text(words, at[0], at[1] + away, 12, weight, this.ink);
    }
    for (const mark of this.marks) {
      const at = mark.kind === 3 && this.project(mark.places[0]);
      if (at) text(mark.text.slice(0, 60), at[0], at[1], 11, 400, this.muted);
    }
    for (const {at, radius, name} of scene.places) {
      const where = this.project([at[0], at[1] - radius, 0]);
      if (where && options.names) text(name.slice(0, 24), where[0], where[1] + 10, 11, 500, this.muted);
    }
    // The scale, along the two edges that are nearer to the eye.
    const [length, width] = scene.arena, eye = this.camera.eye();
    const ticks = (most) => {
      const list = [];
      for (let i = -Math.floor(most / 2 / this.step + 1e-9); i <= most / 2 / this.step + 1e-9; ++i) list.push(i * this.step);
      return list;
    };
    const number = (value) => String(Number(value.toFixed(6))).replace("-", "−");
    if (Math.abs(eye[0]) < length / 2 && Math.abs(eye[1]) < width / 2 && this.following) return;
    const side_y = Math.sin(this.camera.around) <= 1e-6 ? -1 : 1, side_x = Math.cos(this.camera.around) < -1e-6 ? -1 : 1;
    for (const [list, place] of [
      [ticks(length), (value, away) => [value, side_y * (width / 2 + away), 0]],
      [ticks(width), (value, away) => [side_x * (length / 2 + away), value, 0]],
    ]) {
      for (const value of list) {
        const at = this.project(place(value, 0.1)), beyond = this.project(place(value, 0.1 + 0.01 * length));
        if (!at || !beyond) continue;
        const [x, y] = unit([beyond[0] - at[0], beyond[1] - at[1]]);
        text(number(value) + (value === list[list.length - 1] ? " m" : ""), at[0] + 27 * x, at[1] + 16 * y, 10.5, 400, this.muted);
      }
    }
  }

  // The robot at a place of the picture.
  robot_at(x, y) {
    let best = null, nearest = 26;
    for (const robot of this.run.robots) {
      const pose = this.run.pose(robot.body, this.sample), at = pose && this.project([pose.x, pose.y, robot.top / 2]);
      if (!at) continue;
      const away = Math.hypot(at[0] - x, at[1] - y);
      if (away < nearest) [best, nearest] = [robot, away];
    }
    return best;
  }

  // Calls `changed` after each movement of the camera, and `choose` with a robot that is clicked.
  handle(changed, choose) {
    this.changed = changed;
    const pointers = new Map();
    let moved = 0;
    const middle = () => {
      const all = [...pointers.values()], [a, b] = [all[0], all[all.length - 1]];
      return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y), turn: Math.atan2(b.y - a.y, b.x - a.x)};
    };
    const canvas = this.canvas;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
      moved = pointers.size > 1 ? 99 : 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!pointers.has(event.pointerId)) return;
      const before = middle();
      pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
      const now = middle(), dx = now.x - before.x, dy = now.y - before.y;
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size > 1) {
        if (before.apart > 0 && now.apart > 0) this.camera.zoom(before.apart / now.apart);
        this.camera.turn(Math.atan2(Math.sin(now.turn - before.turn), Math.cos(now.turn - before.turn)), 0);
      }
      if (pointers.size > 1 || event.shiftKey || (event.buttons & 6)) {
        this.leave();
        this.camera.slide(-dx / this.height, dy / this.height / Math.max(Math.sin(this.camera.over), 0.25));
      } else {
        this.camera.turn(-dx * 0.006, dy * 0.006);
      }
      changed();
    });
    const end = (event) => {
      if (event.type === "pointerup" && pointers.has(event.pointerId) && moved < 5) {
        const robot = this.robot_at(event.offsetX, event.offsetY);
        if (robot) choose(robot);
      }
      pointers.delete(event.pointerId);
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.camera.zoom(Math.exp(Math.max(-100, Math.min(100, event.deltaY)) * 0.002));
      changed();
    }, {passive: false});
    canvas.addEventListener("keydown", (event) => {
      const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (steps && event.shiftKey) {
        this.leave();
        this.camera.slide(0.06 * steps[0], 0.06 * steps[1]);
      } else if (steps) {
        this.camera.turn(0.1 * steps[0], 0.08 * steps[1]);
      } else if (event.key === "+" || event.key === "=" || event.key === "-") {
        this.camera.zoom(event.key === "-" ? 1.15 : 1 / 1.15);
      } else {
        return;
      }
      event.preventDefault();
      event.stopPropagation();
      changed();
    });
  }
}

