// Draws solids with soft shadows, the floor, and thick lines, with WebGL 2.
const kHead = `#version 300 es
precision highp float;
precision highp sampler2DShadow;
`;
// The part of the sun's light that reaches a place: the mean of neighbouring points of the shadow map.
const kLight = `
uniform sampler2DShadow shadows;
uniform mat4 sun;
uniform vec3 sun_at;
uniform float shaded;
float lit(vec3 place, vec3 normal) {
  float slope = clamp(dot(normal, sun_at), 0.0, 1.0);
  if (shaded < 0.5 || slope <= 0.0) return slope > 0.0 ? 1.0 : 0.0;
  vec4 seen = sun * vec4(place, 1.0);
  vec3 at = seen.xyz * 0.5 + 0.5;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
  at.z -= 0.0006 + 0.0012 * (1.0 - slope);
  vec2 texel = 1.0 / vec2(textureSize(shadows, 0));
  float sum = 0.0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) sum += texture(shadows, at + vec3(vec2(x, y) * texel, 0.0));
  return sum / 25.0;
}
vec3 shade(vec3 colour, vec3 place, vec3 normal) {
  float sky = mix(0.56, 0.72, 0.5 + 0.5 * normal.z);
  return colour * (sky + 0.34 * lit(place, normal) * clamp(dot(normal, sun_at), 0.0, 1.0));
}
`;
const kSolid = [
  `layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 facing;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 tint;
uniform mat4 view;
out vec3 place, normal;
out vec4 colour;
void main() {
  vec4 at = vec4(corner, 1.0);
  place = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at));
  normal = vec3(dot(row_x.xyz, facing), dot(row_y.xyz, facing), dot(row_z.xyz, facing));
  colour = tint;
  gl_Position = view * vec4(place, 1.0);
}`,
  `in vec3 place, normal;
in vec4 colour;
uniform float dim;
out vec4 pixel;
${kLight}
void main() {
  // A colour's fourth number: 1 for what shines by itself.
  pixel = vec4(mix(shade(colour.rgb, place, normalize(normal)) * dim, colour.rgb, colour.a), 1.0);
}`,
];
const kDepth = [
  `layout(location = 0) in vec3 corner;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
uniform mat4 view;
void main() {
  vec4 at = vec4(corner, 1.0);
  gl_Position = view * vec4(dot(row_x, at), dot(row_y, at), dot(row_z, at), 1.0);
}`,
  `void main() {}`,
];
const kFloorLook = [
  `layout(location = 0) in vec3 corner;
layout(location = 1) in vec4 tint;
uniform mat4 view;
out vec3 place;
out vec4 colour;
void main() {
  place = corner;
  colour = tint;
  gl_Position = view * vec4(corner, 1.0);
}`,
  // The floor fades into the room around the arena. Its lines are as wide as a pixel at any distance.
  `in vec3 place;
in vec4 colour;
uniform vec2 arena;
uniform vec3 room, lines;
uniform float step_m, is_floor, is_image, dim;
uniform sampler2D image;
out vec4 pixel;
${kLight}
float line_of(vec2 at, float width) {
  vec2 apart = abs(fract(at + 0.5) - 0.5) / max(fwidth(at), 1e-6);
  return clamp(width - min(apart.x, apart.y), 0.0, 1.0);
}
void main() {
  vec4 own = colour;
  if (is_image > 0.5) {
    vec2 at = (place.xy / arena) + 0.5;
    own *= texture(image, vec2(at.x, 1.0 - at.y));
  }
  float light = lit(place, vec3(0.0, 0.0, 1.0));
  vec3 shown = own.rgb * (0.74 + 0.26 * light) * dim;
  if (is_floor > 0.5) {
    vec2 beyond = abs(place.xy) - 0.5 * arena;
    float outside = max(beyond.x, beyond.y);
    vec2 cells = place.xy / step_m;
    float fine = 0.5 * line_of(cells, 1.0) * (1.0 - smoothstep(0.15, 0.5, max(fwidth(cells).x, fwidth(cells).y)));
    if (outside <= 0.0) {
      shown = mix(shown, lines, fine);
      // A soft shade along the walls.
      shown *= 1.0 - 0.10 * exp(outside / (0.02 * (arena.x + arena.y)));
    } else {
      shown = room * (0.80 + 0.20 * light);
      shown = mix(shown, room, smoothstep(0.0, 0.35 * max(arena.x, arena.y), outside));
    }
  }
  pixel = vec4(shown, own.a);
}`,
];
const kLine = [
  `layout(location = 0) in vec2 side;
layout(location = 1) in vec3 from;
layout(location = 2) in vec3 to;
layout(location = 3) in vec4 tint;
layout(location = 4) in vec2 look;
uniform mat4 view;
uniform vec2 size;
out vec4 colour;
out vec3 across;
out float along, dashes;
void main() {
  vec4 a = view * vec4(from, 1.0), b = view * vec4(to, 1.0);
  // The part in front of the eye.
  float near = 1e-3;
  if (a.w < near && b.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 pa = a.xy / a.w * size * 0.5, pb = b.xy / b.w * size * 0.5;
  vec2 way = pb - pa;
  float length_px = max(length(way), 1e-4);
  way /= length_px;
  float half_px = 0.5 * look.x + 1.0;
  // Parts of a curve have no round ends, which would be seen where they overlap.
  float cap = look.y < -0.5 ? 0.0 : half_px;
  vec2 aside = vec2(-way.y, way.x) * side.y * half_px + way * (side.x * 2.0 - 1.0) * cap;
  vec4 end = side.x > 0.5 ? b : a;
  end.xy += aside / size * 2.0 * end.w;
  end.z -= 2e-4 * end.w;
  colour = tint;
  across = vec3(side.y * half_px, side.x > 0.5 ? length_px + cap : -cap, length_px);
  along = look.x;
  dashes = look.y;
  gl_Position = end;
}`,
  `in vec4 colour;
in vec3 across;
in float along, dashes;
out vec4 pixel;
void main() {
  float beyond = max(max(-across.y, across.y - across.z), 0.0);
  float cover = clamp(0.5 * along + 0.5 - length(vec2(across.x, beyond)), 0.0, 1.0);
  if (dashes > 0.5) cover *= step(fract(across.y / dashes), 0.55);
  if (cover <= 0.0) discard;
  pixel = vec4(colour.rgb, colour.a * cover);
}`,
];

const kSun = unit([-0.42, -0.55, 1.15]);
const kShadowPixels = 2048;
const kSolidFloats = 16, kLineFloats = 12, kFloorFloats = 7;

// Corners and normals of triangles.
class Mesh {
  constructor() {
    this.numbers = [];
  }
  triangle(a, b, c, na, nb = na, nc = na) {
    this.numbers.push(...a, ...na, ...b, ...nb, ...c, ...nc);
  }
  // A convex outline between two heights, counter-clockwise seen from above.
  prism(outline, low, high) {
    const n = outline.length;
    for (let i = 0; i < n; ++i) {
      const [ax, ay] = outline[i], [bx, by] = outline[(i + 1) % n], out = unit([by - ay, ax - bx, 0]);
      this.triangle([ax, ay, low], [bx, by, low], [bx, by, high], out);
      this.triangle([ax, ay, low], [bx, by, high], [ax, ay, high], out);
      if (i < 2) continue;
      const [o, p, q] = [outline[0], outline[i - 1], outline[i]];
      this.triangle([...o, high], [...p, high], [...q, high], [0, 0, 1]);
      this.triangle([...o, low], [...q, low], [...p, low], [0, 0, -1]);
    }
    return this;
  }
  // Around the y axis, of radius 1 and length 1.
  cylinder(sides) {
    const at = (i, y) => [Math.cos((2 * Math.PI * i) / sides), y, Math.sin((2 * Math.PI * i) / sides)];
    for (let i = 0; i < sides; ++i) {
      const n = at(i, 0), m = at(i + 1, 0);
      this.triangle(at(i, 0.5), at(i + 1, 0.5), at(i, -0.5), n, m, n);
      this.triangle(at(i + 1, 0.5), at(i + 1, -0.5), at(i, -0.5), m, m, n);
      this.triangle([0, 0.5, 0], at(i + 1, 0.5), at(i, 0.5), [0, 1, 0]);
      this.triangle([0, -0.5, 0], at(i, -0.5), at(i + 1, -0.5), [0, -1, 0]);
    }
    return this;
  }
  ball(sides) {
    const at = (i, k) => {
      const u = (2 * Math.PI * i) / sides, v = (2 * Math.PI * k) / sides - Math.PI / 2;
      return [Math.cos(u) * Math.cos(v), Math.sin(u) * Math.cos(v), Math.sin(v)];
    };
    for (let i = 0; i < sides; ++i) {
      for (let k = 0; k < sides / 2; ++k) {
        const [a, b, c, d] = [at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
        this.triangle(a, b, c, a, b, c);
        this.triangle(a, c, d, a, c, d);
      }
    }
    return this;
  }
}

class Painter {
  // Throws an error where there is no WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    const gl = (this.gl = canvas.getContext("webgl2", {antialias: true, alpha: false}));
    if (!gl) throw new Error("no WebGL 2");
    this.solid = this.program(kSolid);
    this.depth = this.program(kDepth);
    this.floor = this.program(kFloorLook);
    this.line = this.program(kLine);
    this.side = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.side);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]), gl.STATIC_DRAW);
    this.sheets = gl.createBuffer();
    this.segments = gl.createBuffer();
    this.instances = gl.createBuffer();
    this.array = gl.createVertexArray();
    gl.bindVertexArray(this.array);
    this.shadows = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadows);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, kShadowPixels, kShadowPixels);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    this.target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadows, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.white = this.texture(1, 1, new Uint8Array([255, 255, 255, 255]));
  }

  program([vertex, fragment]) {
    const gl = this.gl, program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, kHead + text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "no WebGL 2");
    const places = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const {name} = gl.getActiveUniform(program, i);
      places[name] = gl.getUniformLocation(program, name);
    }
    return {program, places};
  }

  texture(width, height, pixels) {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    this.smooth();
    return texture;
  }
  image_texture(image) {
    const gl = this.gl, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
    this.smooth();
    return texture;
  }
  smooth() {
    const gl = this.gl;
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  }

  upload(mesh) {
    const gl = this.gl, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(mesh.numbers), gl.STATIC_DRAW);
    return {buffer, corners: mesh.numbers.length / 6};
  }

  attributes(list, stride, divisor) {
    const gl = this.gl;
    let offset = 0;
    for (const [place, count] of list) {
      if (place >= 0) {
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, count, gl.FLOAT, false, 4 * stride, 4 * offset);
        gl.vertexAttribDivisor(place, divisor);
      }
      offset += count;
    }
  }

  use({program, places}, values) {
    const gl = this.gl;
    for (let i = 0; i < 6; ++i) gl.disableVertexAttribArray(i);
    gl.useProgram(program);
    for (const [name, value] of Object.entries(values)) {
      const place = places[name];
      if (place === undefined) continue;
      if (typeof value === "number") gl.uniform1f(place, value);
      else if (value.length === 2) gl.uniform2fv(place, value);
      else if (value.length === 3) gl.uniform3fv(place, value);
      else gl.uniformMatrix4fv(place, false, value);
    }
    if (places.shadows) gl.uniform1i(places.shadows, 0);
    if (places.image) gl.uniform1i(places.image, 1);
    return places;
  }

  draw_solids(groups) {
    const gl = this.gl;
    for (const {mesh, numbers} of groups) {
      if (numbers.length === 0) continue;
      gl.bindBuffer(gl.ARRAY_BUFFER, mesh.buffer);
      this.attributes([[0, 3], [1, 3]], 6, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      this.attributes([[2, 4], [3, 4], [4, 4], [5, 4]], kSolidFloats, 1);
      gl.drawArraysInstanced(gl.TRIANGLES, 0, mesh.corners, numbers.length / kSolidFloats);
    }
  }

  // frame: view, size (pixels), arena, height of what stands there, room, floor, lines (colours), step_m, dim, shaded;
  // sheets: {texture, corners} above the floor, in order; solids: {mesh, numbers}; segments: numbers of lines.
  draw(frame, sheets, solids, segments) {
    const gl = this.gl;
    const reach = 0.5 * Math.hypot(...frame.arena) + frame.height;
    const sun = multiplied(parallel(reach, reach, 0.1, 4 * reach),
                           looking(kSun.map((each) => 2 * reach * each), kSun.map((each) => -each), [0, 1, 0]));
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    if (frame.shaded) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
      gl.viewport(0, 0, kShadowPixels, kShadowPixels);
      gl.clear(gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(1.5, 2);
      this.use(this.depth, {view: sun});
      this.draw_solids(solids);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }
    gl.viewport(0, 0, ...frame.size);
    gl.clearColor(...frame.room, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.shadows);
    const light = {...frame, sun, sun_at: kSun, shaded: frame.shaded ? 1 : 0};

    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE);
    const places = this.use(this.floor, light);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.sheets);
    // Sheets lie in the same plane, one after the other; what stands there covers them.
    gl.depthMask(false);
    const far = 12 * Math.max(...frame.arena);
    const base = [[-far, -far], [far, -far], [far, far], [-far, -far], [far, far], [-far, far]]
      .flatMap(([x, y]) => [x, y, 0, ...frame.floor, 1]);
    for (const sheet of [{corners: new Float32Array(base), base: true}, ...sheets]) {
      gl.uniform1f(places.is_floor, sheet.base ? 1 : 0);
      gl.uniform1f(places.is_image, sheet.texture ? 1 : 0);
      gl.uniform2fv(places.arena, sheet.size ?? frame.arena);
      gl.bindTexture(gl.TEXTURE_2D, sheet.texture ?? this.white);
      gl.bufferData(gl.ARRAY_BUFFER, sheet.corners, gl.DYNAMIC_DRAW);
      this.attributes([[0, 3], [1, 4]], kFloorFloats, 0);
      gl.drawArrays(gl.TRIANGLES, 0, sheet.corners.length / kFloorFloats);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);

    this.use(this.solid, light);
    this.draw_solids(solids);

    gl.enable(gl.BLEND);
    gl.depthMask(false);
    this.use(this.line, frame);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.side);
    this.attributes([[0, 2]], 2, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.segments);
    gl.bufferData(gl.ARRAY_BUFFER, segments, gl.DYNAMIC_DRAW);
    this.attributes([[1, 3], [2, 3], [3, 4], [4, 2]], kLineFloats, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, segments.length / kLineFloats);
    gl.depthMask(true);
  }

  // The colour of a pixel, counted from the top left, just after a picture was drawn.
  pixel(x, y) {
    const gl = this.gl, bytes = new Uint8Array(4);
    gl.readPixels(Math.round(x), this.canvas.height - 1 - Math.round(y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return [...bytes.subarray(0, 3)];
  }
}

