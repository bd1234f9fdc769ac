// Matrices as WebGL has them, column after column, and the camera. x is east, y north, z up.
const multiplied = (a, b) => {
  const out = new Float32Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += a[4 * k + row] * b[4 * column + k];
      out[4 * column + row] = sum;
    }
  }
  return out;
};
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const inner = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (v) => {
  const length = Math.hypot(...v) || 1;
  return v.map((each) => each / length);
};
// The world as seen from `eye` along `ahead`; `top` is somewhere upwards.
const looking = (eye, ahead, top) => {
  const right = unit(cross(ahead, top)), up = cross(right, ahead);
  return new Float32Array([
    right[0], up[0], -ahead[0], 0, right[1], up[1], -ahead[1], 0, right[2], up[2], -ahead[2], 0,
    -inner(right, eye), -inner(up, eye), inner(ahead, eye), 1,
  ]);
};
const parallel = (x, y, near, far) =>
  new Float32Array([1 / x, 0, 0, 0, 0, 1 / y, 0, 0, 0, 0, -2 / (far - near), 0, 0, 0, -(far + near) / (far - near), 1]);

const kFieldOfView = 0.62;  // rad, of the shorter side of the picture

class Camera {
  constructor() {
    this.at = [0, 0, 0];  // what it looks at
    this.around = -Math.PI / 2;  // where it stands from there, rad counter-clockwise from east
    this.over = 0.9;  // its height, rad above the floor
    this.raised = 0;  // how much higher it is, so that nothing hides what it looks at
    this.distance = 10;
  }

  // Shows an area of the floor with its walls in a picture of this size, px, with room for buttons above and numbers around it.
  show(length, width, height, size, over = 0.9) {
    const aspect = size[0] / size[1], top = 1 - 108 / size[1], bottom = 76 / size[1] - 1, side = 1 - 84 / size[0];
    this.at = [0, 0, 0];
    this.around = -Math.PI / 2;
    this.over = over;
    this.raised = 0;
    this.distance = Math.max(length, width);
    const wall = 0.1;  // m, beside the arena
    const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [0, height].map((z) => [x * (length / 2 + wall), y * (width / 2 + wall), z])));
    // A step nearer or farther, and up or down, until the corners fill the picture.
    for (let i = 0; i < 60; ++i) {
      const view = this.matrix(aspect);
      const seen = corners.map((corner) => this.clip(view, corner)).map(([x, y, w]) => [x / Math.max(w, 1e-9), y / Math.max(w, 1e-9)]);
      const wide = Math.max(...seen.map(([x]) => Math.abs(x))) / Math.max(side, 0.4);
      const high = Math.max(...seen.map(([, y]) => y)), low = Math.min(...seen.map(([, y]) => y));
      this.slide(0, (high + low - top - bottom) / 4);
      this.distance *= Math.max(wide, (high - low) / Math.max(top - bottom, 0.8)) ** 0.7;
    }
  }

  turn(around, over) {
    this.around += around;
    this.over = Math.min(Math.PI / 2, Math.max(0.05, this.over + this.raised + over));  // never below the floor
    this.raised = 0;
  }

  // Moves what it looks at, in parts of the picture's height.
  slide(right, up) {
    const scale = 2 * this.distance * Math.tan(kFieldOfView / 2);
    const c = Math.cos(this.around), s = Math.sin(this.around);
    this.at[0] += scale * (-s * right - c * up);
    this.at[1] += scale * (c * right - s * up);
  }

  zoom(factor) {
    this.distance = Math.min(1e4, Math.max(0.05, this.distance * factor));
  }

  ahead() {
    const over = Math.min(Math.PI / 2, this.over + this.raised), flat = Math.cos(over);
    return [-Math.cos(this.around) * flat, -Math.sin(this.around) * flat, -Math.sin(over)];
  }

  eye() {
    return this.at.map((each, i) => each - this.distance * this.ahead()[i]);
  }

  matrix(aspect) {
    const near = this.distance / 50, far = this.distance * 40;
    const f = 1 / Math.tan(kFieldOfView / 2);
    const [fx, fy] = aspect > 1 ? [f / aspect, f] : [f, f * aspect];
    const project = new Float32Array([
      fx, 0, 0, 0, 0, fy, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0, (2 * near * far) / (near - far), 0,
    ]);
    const top = [-Math.cos(this.around), -Math.sin(this.around), 1e-3];
    return multiplied(project, looking(this.eye(), this.ahead(), top));
  }

  clip(view, p) {
    return [0, 1, 3].map((row) => view[row] * p[0] + view[4 + row] * p[1] + view[8 + row] * p[2] + view[12 + row]);
  }
}

