// What stands along the axes of a diagram's page, and the names of its special points.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { join } from 'node:path';
import { pixelsOf, settled } from './browser.mjs';
import { folder, inPage, once, pageOf, range, scene, text, written } from './pages.mjs';

const response = pageOf('response.html', 'diagram', scene('05_wagg_one_mode.toml'), '--parameter', 'forcing.frequency',
  '--from', '15', '--to', '120', '--points', '120', '--direction', 'down', '--set', 'stop.gap=1.05e-3', '--branches', 'all', '--amplitudes',
  '--exponents', '20', '--out', join(folder, 'response'));
// The special points by their ids, once the page is there.
const points = once(() => Object.fromEntries(written('response', 'special.csv').map((row) => [row.id, row])));

// The ranges in view, SI or the units of the page, as those who do not see the picture are told.
async function inView(page) {
  const told = (await range(page)).replaceAll('−', '-').replaceAll(/·10([⁻⁰¹²³⁴-⁹]+)/g,
    (_, power) => `e${[...power].map((c) => '⁰¹²³⁴⁵⁶⁷⁸⁹'.includes(c) ? '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c) : '-').join('')}`);
  const [, y0, y1, x0, x1] = told.match(/from (\S+).*? to (\S+).* over .*? from (\S+).*? to (\S+?)[ .]*(?: |\.$|\. )/);
  return { x: [x0, x1].map(Number), y: [y0, y1].map(Number) };
}

// Where a value lies on the screen, its unit being that of the range.
async function placeOf(page, { x, y }, { hertz = false, strip = false, scale = { x: Number, y: Number } } = {}) {
  const box = await (await page.$('#chart')).boundingBox();
  const seen = await inView(page);
  const part = (value, [low, high], of) => (of(value) - of(low)) / (of(high) - of(low));
  // A strip of 2.6 cm of 58 px, 22 px below.
  const top = hertz ? 52 : 14, bottom = strip ? 50 + 22 + 2.6 * 58 : 50;
  return {
    x: box.x + 92 + part(x, seen.x, scale.x) * (box.width - 112),
    y: box.y + box.height - bottom - part(y, seen.y, scale.y) * (box.height - top - bottom),
  };
}

async function pointedAt(page, ...place) {
  const { x, y } = await placeOf(page, ...place);
  await page.mouse.move(x, y);
  return text(page, '#hover');
}

const chosen = (page, selector) => page.$eval(selector, (select) => select.selectedOptions[0].textContent);

inPage('all that was measured can stand along both axes', response, async (page) => {
  const names = (selector) => page.$$eval(`${selector} option`, (list) => list.map((option) => option.textContent));
  const all = await names('#observable');
  for (const name of ['impact speed', 'forcing phase of the impact', 'amplitude at stop 1', 'largest value at stop 1',
    'smallest value at stop 1', 'root mean square at stop 1', 'first harmonic at stop 1', 'largest velocity at stop 1',
    'impacts per time at stop 1', 'largest multiplier, modulus', 'largest exponent', 'forcing frequency Ω'])
    assert.ok(all.includes(name), `${name} in ${all}`);
  assert.deepEqual(await names('#abscissa'), all);
  assert.equal(await chosen(page, '#abscissa'), 'forcing frequency Ω');
});

inPage('a special point is found by two of its numbers, and told all', response, async (page) => {
  const { phase, speed } = points().PD2;
  await page.selectOption('#abscissa', 'phase');
  assert.match(await range(page), /^impact speed from .* over forcing phase of the impact from .* rad/);
  assert.ok(await pixelsOf(page, '#dots') > 200);
  const told = await pointedAt(page, { x: Number(phase), y: Number(speed) });
  assert.match(told, /^PD2: period doubling, \(1,1\)forcing frequency Ω59\.537\d+ rad\/simpact speed0\.02561\d* m\/sforcing phase of the impact3\.103\d* rad/);
});

inPage('a quantity leaves one axis for the other', response, async (page) => {
  await page.selectOption('#observable', { label: 'forcing frequency Ω' });
  assert.equal(await chosen(page, '#abscissa'), 'impact speed');
  assert.match(await range(page), /^forcing frequency Ω from 15 rad\/s to 120 rad\/s over impact speed from/);
  const { value, speed } = points().PD2;
  assert.match(await pointedAt(page, { x: Number(speed), y: Number(value) }), /^PD2: /);
});

inPage('scales are linear, logarithmic or in decibels', response, async (page) => {
  const { value, speed } = points().PD2;
  const place = { x: Number(value), y: Number(speed) };
  const linear = await pixelsOf(page, '#dots');
  await page.selectOption('#observable-scale', 'decibel');
  assert.match(await pointedAt(page, place, { hertz: true, strip: true, scale: { x: Number, y: Math.log } }), /^PD2: .*impact speed0\.02561\d* m\/s/);
  await page.selectOption('#observable-scale', 'log');
  await page.selectOption('#abscissa-scale', 'log');
  // Without the axis in Hz.
  assert.match(await pointedAt(page, place, { strip: true, scale: { x: Math.log, y: Math.log } }), /^PD2: .*Ω59\.537/);
  assert.notEqual(await pixelsOf(page, '#dots'), linear);
  await page.click('#zoom-in');
  await settled(page);
  assert.match(await pointedAt(page, place, { strip: true, scale: { x: Math.log, y: Math.log } }), /^PD2: /);
  await page.selectOption('#observable', 'exponent');  // of either sign
  assert.match(await range(page), /^largest exponent from [\d.e·⁻¹²³]+ 1\/s/);
});

inPage('what is nowhere above zero has no logarithm', response, async (page) => {
  const offers = () => page.$eval('#observable-scale', (select) => [...select.options].map((option) => !option.disabled));
  assert.deepEqual(await offers(), [true, true, true]);
  await page.selectOption('#observable-scale', 'log');
  await page.selectOption('#observable', 'min.stop.1');
  const low = written('response', 'sweep.csv');
  assert.ok(low.length > 100);
  // The smallest displacement of every motion is below the place of rest.
  assert.deepEqual(await offers(), [true, false, true]);
  assert.equal(await chosen(page, '#observable-scale'), 'linear');
});

inPage('amplitudes of motions that meet no stop are there too', response, async (page) => {
  await page.selectOption('#observable', 'amplitude.stop.1');
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, '#hover'), /amplitude at stop 1[\d.]+ mm/);
  const legend = await page.$$eval('#legend button', (list) => list.map((button) => button.dataset.type));
  assert.ok(legend.includes('stable') && legend.includes('sweep: periodic'), `${legend}`);
});

// Ink above a mark, where its name stands.
async function namedAt(page, id) {
  const { x, y } = await placeOf(page, { x: Number(points()[id].value), y: Number(points()[id].speed) }, { hertz: true, strip: true });
  return page.$eval('#chart canvas', (canvas, [px, py]) => {
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    const { data } = canvas.getContext('2d').getImageData((px - box.x - 12) * scale, (py - box.y - 22) * scale, 24, 12);
    let ink = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200 && data[i] + data[i + 1] + data[i + 2] < 240) ++ink;
    return ink;
  }, [x, y]);
}

inPage('marks carry their ids, which a button hides', response, async (page) => {
  assert.ok(await namedAt(page, 'PD2') > 10);
  await page.click('#labels');
  await settled(page);
  assert.equal(await page.getAttribute('#labels', 'aria-pressed'), 'false');
  assert.equal(await namedAt(page, 'PD2'), 0);
  await page.click('#labels');
  await settled(page);
  assert.ok(await namedAt(page, 'PD2') > 10);
});

// Dark pixels of the whole picture.
const inkOf = (page) => page.$eval('#chart canvas', (canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let ink = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200 && data[i] + data[i + 1] + data[i + 2] < 240) ++ink;
  return ink;
});

inPage('branches carry their names while they are shown', response, async (page) => {
  const toggle = async (selector) => { await page.click(selector); await settled(page); };
  const buttons = await page.$$eval('#legend button', (list) => list.map(({ dataset }) => dataset.type));
  for (const type of buttons.filter((type) => / \((GR|PD|LP|NS)\)$/.test(type))) await toggle(`#legend button[data-type="${type}"]`);
  const named = await inkOf(page);
  await toggle('#labels');
  const bare = await inkOf(page);
  assert.ok(named > bare + 20, `${named} of ${bare}`);
  await toggle('#labels');
  for (const type of buttons.filter((type) => ['stable', 'unstable'].includes(type))) await toggle(`#legend button[data-type="${type}"]`);
  assert.equal(await inkOf(page), bare);
});

test('the name of a branch stands in the middle of its longest part in view', async () => {
  const { lineNames } = await import(scene('../../lib/graze/report/page/line_names.js'));
  const places = Array.from({ length: 101 }, (_, i) => i);
  // Things 0 and 1 are points of two branches, 2 a special point of the first.
  const kinds = [{ of: 'branch 1', name: '(1,1)' }, { of: 'branch 2', name: '(2,2)' }, { of: 'PD1', name: 'PD1' }];
  const things = { kindOf: (thing) => kinds[thing] };
  const lines = [
    { of: places.map(() => 0), x: places, y: places.map(() => 1) },
    { of: places.map((x) => (x % 10 === 0 ? 2 : 0)), x: places, y: places.map((x) => x / 10) },
    { of: places.map(() => 1), x: places, y: places.map(() => 50) },
  ];
  assert.deepEqual(lineNames(lines, things, { x: [40, 80], y: [0, 5] }), [{ value: [60, 1], name: '(1,1)' }]);
  assert.deepEqual(lineNames(lines, things, { x: [40, 80], y: [4, 60] }).map(({ value }) => value), [[60, 6], [60, 50]]);
  assert.deepEqual(lineNames(lines, things, { x: [200, 300], y: [0, 5] }), []);
});

inPage('the orbit at a special point is titled by its id', response, async (page) => {
  const { x, y } = await placeOf(page, { x: Number(points().PD2.value), y: Number(points().PD2.speed) }, { hertz: true, strip: true });
  await page.mouse.click(x, y);
  await settled(page);
  assert.equal(await text(page, '#orbit-title'), 'PD2: period doubling, (1,1)');
  assert.match(await text(page, '#orbit-facts'), /Ω 59\.537\d+ rad\/s .*largest multiplier 1 in modulus/);
  await page.click('#tables button:text("PD1")');
  assert.equal(await text(page, '#orbit-title'), 'PD1: period doubling, (1,1)');
});
