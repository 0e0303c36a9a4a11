// Numbers and names as people read them.

// To `digits` significant digits, with a true minus sign and without zeros at the end.
export function number(value, digits = 5) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size < 1e-4 || size >= 1e7
    ? value.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace(/e([+-])(\d+)/, powerOfTen)
    : String(Number(value.toPrecision(digits)));
  return text.replace('-', '−');
}

const kRaised = { '-': '⁻', '+': '', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };

function powerOfTen(_, sign, power) {
  return '·10' + [...(sign + power)].map((c) => kRaised[c]).join('');
}

// "impact speed (m/s)", or the name alone for a pure number.
export function axisName(quantity) {
  return quantity.unit ? `${quantity.name} (${quantity.unit})` : quantity.name;
}

// An SI value in the quantity's own unit.
export function measure(quantity, value, digits) {
  const text = number(quantity.factor * value, digits);
  return quantity.unit ? `${text} ${quantity.unit}` : text;
}

// An element with its attributes, properties by name, and children.
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// Rows of cells; the first row is the head.
export function table(rows) {
  const [head, ...body] = rows;
  const line = (tag, cells) => element('tr', {}, ...cells.map((cell) => element(tag, {}, cell)));
  return element('table', { class: 'list' },
    element('thead', {}, line('th', head)),
    element('tbody', {}, ...body.map((cells) => line('td', cells))));
}
