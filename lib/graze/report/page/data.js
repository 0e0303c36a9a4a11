// What the program left in the page: two JSON texts, whose long lists of numbers are the bytes of
// typed arrays in base 64 ({"f32": ".."}), little-endian.
const kArrays = { f64: Float64Array, f32: Float32Array, i32: Int32Array, u8: Uint8Array };

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

function isArray(value) {
  const keys = Object.keys(value);
  return keys.length === 1 && keys[0] in kArrays && typeof value[keys[0]] === 'string';
}

// `value` with typed arrays in place of their base 64, in all its parts.
export function unpacked(value) {
  if (value === null || typeof value !== 'object') return value;
  if (Array.isArray(value)) return value.map(unpacked);
  if (isArray(value)) {
    const kind = Object.keys(value)[0];
    return new kArrays[kind](bytesOf(value[kind]).buffer);
  }
  return Object.fromEntries(Object.entries(value).map(([key, part]) => [key, unpacked(part)]));
}

export function readView() {
  return unpacked(JSON.parse(document.getElementById('view').textContent));
}

// The orbits are the larger part of a page and are read when the first is asked for; each is
// unpacked alone.
export class Orbits {
  get(index) {
    this.list ??= JSON.parse(document.getElementById('orbits').textContent);
    return unpacked(this.list[index]);
  }
}
