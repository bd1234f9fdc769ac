// DEFLATE (RFC 1951): the bytes of compressed ones.
const inflate = (packed) => {
  let out = new Uint8Array(packed.length * 6), size = 0, at = 0, held = 0, bits = 0;
  const take = (count) => {
    while (bits < count) {
      if (at >= packed.length) throw new Error("the data of this page are cut off");
      held |= packed[at++] << bits;
      bits += 8;
    }
    const value = held & ((1 << count) - 1);
    held >>>= count;
    bits -= count;
    return value;
  };
  const room = (count) => {
    if (size + count <= out.length) return;
    const larger = new Uint8Array(2 * (size + count));
    larger.set(out);
    out = larger;
  };
  // The code of these lengths: how many codes have each length, and the symbols in their order.
  const code_of = (lengths) => {
    const counts = new Uint16Array(16), starts = new Uint16Array(16), symbols = new Uint16Array(lengths.length);
    for (const length of lengths) ++counts[length];
    counts[0] = 0;
    for (let i = 1; i < 16; ++i) starts[i] = starts[i - 1] + counts[i - 1];
    lengths.forEach((length, symbol) => {
      if (length) symbols[starts[length]++] = symbol;
    });
    return {counts, symbols};
  };
  const symbol_of = ({counts, symbols}) => {
    let value = 0, first = 0, index = 0;
    for (let length = 1; length < 16; ++length) {
      value |= take(1);
      const count = counts[length];
      if (value - count < first) return symbols[index + value - first];
      index += count;
      first = (first + count) << 1;
      value <<= 1;
    }
    throw new Error("the data of this page are damaged");
  };
  const range = (count, more, step) => {
    // Bases and extra bits of lengths and distances.
    const bases = [more], extras = [];
    for (let i = 0; i < count; ++i) {
      extras.push(Math.max(0, Math.floor(i / step) - 1));
      bases.push(bases[i] + (1 << extras[i]));
    }
    return {bases, extras};
  };
  const lengths = range(28, 3, 4), distances = range(30, 1, 2);
  lengths.bases[28] = 258;
  lengths.extras[28] = 0;
  const fixed = [
    code_of(Array.from({length: 288}, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8))),
    code_of(Array(30).fill(5)),
  ];
  const read_codes = () => {
    const many = take(5) + 257, far = take(5) + 1, count = take(4) + 4;
    const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
    const own = Array(19).fill(0);
    for (let i = 0; i < count; ++i) own[order[i]] = take(3);
    const code = code_of(own), all = [];
    while (all.length < many + far) {
      const symbol = symbol_of(code);
      if (symbol < 16) all.push(symbol);
      else if (symbol === 16) all.push(...Array(3 + take(2)).fill(all[all.length - 1]));
      else all.push(...Array(symbol === 17 ? 3 + take(3) : 11 + take(7)).fill(0));
    }
    return [code_of(all.slice(0, many)), code_of(all.slice(many))];
  };
  for (let last = 0; !last;) {
    last = take(1);
    const kind = take(2);
    if (kind === 0) {
      at -= bits >> 3;
      held = bits = 0;
      const count = packed[at] | (packed[at + 1] << 8);
      room(count);
      out.set(packed.subarray(at + 4, at + 4 + count), size);
      at += 4 + count;
      size += count;
      continue;
    }
    const [literals, ways] = kind === 1 ? fixed : read_codes();
    for (;;) {
      const symbol = symbol_of(literals);
      if (symbol === 256) break;
      room(258);
      if (symbol < 256) {
        out[size++] = symbol;
        continue;
      }
      const length = lengths.bases[symbol - 257] + take(lengths.extras[symbol - 257]);
      const way = symbol_of(ways), back = distances.bases[way] + take(distances.extras[way]);
      for (let i = 0; i < length; ++i, ++size) out[size] = out[size - back];
    }
  }
  return out.subarray(0, size);
};

