// The pages of diagram, continue and orbit (--plot x.html), in a browser: what is drawn, hovered over,
// zoomed into and clicked on.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { openPage, pixelsOf, placeOf, settled } from './browser.mjs';
import { again, browser, folder, ground, inPage, isShown, packed, pageOf, range, scene, text } from './pages.mjs';

const oneMode = scene('05_wagg_one_mode.toml');
const kBlack = [0, 40], kGrey = [120, 200];

const diagram = pageOf('diagram.html', 'diagram', oneMode, '--parameter', 'forcing.frequency', '--from', '15',
  '--to', '120', '--points', '400', '--direction', 'down', '--set', 'stop.gap=1.05e-3', '--branches', 'all');
const exponents = pageOf('exponents.html', 'diagram', oneMode, '--parameter', 'forcing.frequency', '--from', '55',
  '--to', '75', '--points', '80', '--exponents', '100', '--branches', 'none');
const gap = pageOf('gap.html', 'continue', oneMode, '--set', 'forcing.frequency=40', '--parameter', 'stop.gap',
  '--from', '0', '--to', '0.02');
const orbits = pageOf('orbits.html', 'orbit', oneMode, '--set', 'forcing.frequency=40', '--set', 'stop.gap=0.01');
const supports = pageOf('supports.html', 'orbit', scene('07_two_stops.toml'));
const stroboscopic = pageOf('stroboscopic.html', 'diagram', scene('04_impact_oscillator.toml'), '--parameter',
  'forcing.amplitude', '--from', '0.2', '--to', '1', '--points', '60', '--section', 'stroboscopic',
  '--set', 'forcing.frequency=1.6', '--set', 'stop.gap=0.5', '--set', 'initial.q=[0.0]');

inPage('a diagram is drawn, with dots, lines and marks', diagram, async (page) => {
  assert.equal(await text(page, 'h1'), 'Bifurcation diagram');
  assert.ok(await pixelsOf(page, '#dots') > 3000);
  assert.ok(await pixelsOf(page, '#chart canvas') > 5000);
  const types = await page.$$eval('#legend button', (list) => list.map((button) => button.dataset.type));
  for (const type of ['sweep: periodic', 'sweep: not periodic', 'stable', 'unstable', 'period doubling (PD)', 'grazing (GR)']) assert.ok(types.includes(type), type);
});

inPage('the pointer is told the values under it', diagram, async (page) => {
  const place = await placeOf(page, '#dots', { x: 0.8, y: 0.4 }, kBlack);
  await page.mouse.move(place.x, place.y);
  const told = await text(page, '#hover');
  assert.match(told, /sweep: \(\d+,\d+\)/);
  assert.match(told, /forcing frequency Ω\d+(\.\d+)? rad\/s/);
  assert.match(told, /impact speed\d\.\d+ m\/s/);
  assert.ok(await isShown(page, '#ring'));
  await page.mouse.move(5, 5);
  assert.ok(!await isShown(page, '#hover'));
});

inPage('wheel, rectangle, buttons and keys zoom', diagram, async (page) => {
  const whole = await range(page);
  assert.match(whole, /impact speed from .* over forcing frequency Ω from 15 rad\/s to 120 rad\/s/);
  const box = await (await page.$('#chart')).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -500);
  await settled(page);
  const wheeled = await range(page);
  assert.notEqual(wheeled, whole);
  await page.click('#zoom-reset');
  assert.equal(await range(page), whole);
  await page.click('#zoom-in');
  assert.notEqual(await range(page), whole);
  await page.focus('#chart');
  await page.keyboard.press('0');
  assert.equal(await range(page), whole);
  await page.click('#zoom-box');
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.3 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const [low, high] = (await range(page)).match(/Ω from ([\d.]+) rad\/s to ([\d.]+) rad/).slice(1).map(Number);
  assert.ok(low > 50 && low < 65 && high > 60 && high < 75, `${low} to ${high}`);
  assert.equal(await page.getAttribute('#zoom-box', 'aria-pressed'), 'false');
});

inPage('a click opens the orbit, and its command makes it again', diagram, async (page) => {
  const place = await placeOf(page, '#dots', { x: 0.8, y: 0.4 }, kBlack);
  await page.mouse.click(place.x, place.y);
  await settled(page);
  assert.ok(await isShown(page, '#orbit'));
  assert.match(await text(page, '#orbit-title'), /^\(2,1\) orbit$/);
  for (const part of ['series', 'portrait', 'circle']) assert.ok(await pixelsOf(page, `#orbit-${part} canvas`) > 500, part);
  const speeds = await page.$$eval('#orbit-impacts tbody tr', (rows) => rows.map((row) => Number(row.cells[2].textContent)));
  assert.equal(speeds.length, 1);
  const command = await text(page, '#orbit-command');
  assert.match(command, /--set stop\.gap=1\.05e-3 /);
  const found = again(command).orbits.flatMap((orbit) => orbit.speeds);
  assert.ok(found.some((speed) => Math.abs(speed - speeds[0]) < 1e-5 * speed), `${found} without ${speeds}`);
  await page.click('#orbit-close');
  assert.ok(!await isShown(page, '#orbit'));
});

inPage('a motion that never repeats opens as one, from where the sweep was', diagram, async (page) => {
  const place = await placeOf(page, '#dots', { x: 0.9, y: 0.7 }, kGrey);
  await page.mouse.click(place.x, place.y);
  await settled(page);
  assert.equal(await text(page, '#orbit-title'), 'not periodic');
  assert.ok(await pixelsOf(page, '#orbit-series canvas') > 500);
  const rows = await page.$$eval('#orbit-impacts tbody tr', (list) => list.map((row) => Number(row.cells[2].textContent)));
  const run = again(await text(page, '#orbit-command'));
  const speeds = run.events.filter((event) => event.kind === 'impact').map((event) => event.speed);
  // Chaos: only the beginning is the same to all digits shown.
  for (let i = 0; i < 5; ++i) assert.ok(Math.abs(rows[i] - speeds[i]) < 1e-4 * speeds[i], `${rows[i]} is not ${speeds[i]}`);
});

inPage('the legend hides by type', diagram, async (page) => {
  const all = await pixelsOf(page, '#dots');
  await page.click('#legend button[data-type="sweep: not periodic"]');
  const periodic = await pixelsOf(page, '#dots');
  assert.ok(periodic > 0 && periodic < all);
  await page.click('#legend button[data-type="sweep: periodic"]');
  assert.equal(await pixelsOf(page, '#dots'), 0);
  const before = await pixelsOf(page, '#chart canvas');
  await page.click('#legend button[data-type="stable"]');
  await settled(page);
  assert.ok(await pixelsOf(page, '#chart canvas') < before);
});

inPage('what is shown can be switched', diagram, async (page) => {
  const names = await page.$$eval('#observable option', (list) => list.map((option) => option.textContent));
  assert.deepEqual(names, ['impact speed', 'forcing phase of the impact', 'largest multiplier, modulus', 'forcing frequency Ω']);
  const speed = await pixelsOf(page, '#dots');
  await page.selectOption('#observable', 'phase');
  assert.match(await range(page), /^forcing phase of the impact from .* rad over/);
  assert.notEqual(await pixelsOf(page, '#dots'), speed);
  await page.selectOption('#observable', 'multiplier');
  assert.equal(await pixelsOf(page, '#dots'), 0);
});

inPage('keys go from point to point and open the orbit', gap, async (page) => {
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  const first = await text(page, '#hover');
  assert.match(first, /branch 1, \(1,1\): stable/);
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await text(page, '#hover'), first);
  await page.keyboard.press('Enter');
  await settled(page);
  assert.match(await text(page, '#orbit-facts'), /gap [\d.]+ mm · stable · largest multiplier 0\.\d+/);
  const named = /--set 'stop\.gap=|--set stop\.gap=/;
  assert.match(await text(page, '#orbit-command'), named);
  await page.keyboard.press('Escape');
  assert.ok(!await isShown(page, '#orbit'));
});

inPage('special points open from their table', gap, async (page) => {
  await page.click('#tables button:text("LP1")');
  await settled(page);
  // The fold of the README, at a gap of 13.592831 mm.
  assert.match(await text(page, '#orbit-facts'), /gap 13\.59283\d* mm/);
  const [orbit] = again(await text(page, '#orbit-command')).orbits;
  assert.ok(Math.abs(orbit.speeds[0] - 0.662861838) < 1e-4, `${orbit.speeds}`);
});

inPage('orbits are drawn in one phase plane', orbits, async (page) => {
  const titles = await page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
  assert.match(titles.join('; '), /orbit 1, \(1,1\) stable, v = [\d.]+ m\/s; .*orbit 2, \(1,1\) unstable, v = [\d.]+ m\/s/);
  const box = await (await page.$('#chart')).boundingBox();
  const curve = await placeOf(page, '#chart canvas', { x: 0.2, y: 0.5 }, [60, 140]);
  await page.mouse.move(curve.x, curve.y);
  assert.match(await text(page, '#hover'), /velocity.*−?[\d.·⁻]+ m/);
  const whole = await range(page);
  await page.mouse.wheel(0, -300);
  await settled(page);
  assert.notEqual(await range(page), whole);
  await page.click('#tables button >> nth=1');
  await settled(page);
  assert.match(await text(page, '#orbit-facts'), /unstable/);
  assert.ok(box.width > 600);
});

inPage('two stops are both there', supports, async (page) => {
  await page.click('#tables button >> nth=0');
  await settled(page);
  assert.ok(await pixelsOf(page, '#orbit-series canvas') > 500);
});

inPage('a stroboscopic diagram shows displacements and velocities', stroboscopic, async (page) => {
  const names = await page.$$eval('#observable option', (list) => list.map((option) => option.textContent));
  assert.ok(names.includes('displacement towards the stop') && names.includes('velocity towards the stop'), `${names}`);
  assert.ok(await pixelsOf(page, '#dots') > 100);
  const place = await placeOf(page, '#dots', { x: 0.5, y: 0.5 }, kBlack);
  await page.mouse.click(place.x, place.y);
  await settled(page);
  assert.ok(await isShown(page, '#orbit'));
});

test('dark and light differ, by the system and by the button', async () => {
  const dark = await openPage(browser, diagram(), { colorScheme: 'dark' });
  const light = await openPage(browser, diagram(), { colorScheme: 'light' });
  assert.equal(await ground(light.page), 'rgb(255, 255, 255)');
  assert.notEqual(await ground(dark.page), await ground(light.page));
  await placeOf(dark.page, '#dots', { x: 0.8, y: 0.4 }, [230, 255]);  // dots are white there
  await dark.page.click('#theme');
  assert.equal(await ground(dark.page), await ground(light.page));
  assert.deepEqual([...dark.wrong, ...light.wrong], []);
  await Promise.all([dark.close(), light.close()]);
});

// A page of the program with its view changed.
function changed(name, change) {
  const file = join(folder, name);
  writeFileSync(file, readFileSync(diagram(), 'utf8').replace(/(id="view">)(.*?)(<\/script>)/s, (_, open, json, close) => {
    const view = JSON.parse(json);
    change(view);
    return open + JSON.stringify(view).replaceAll('<', '\\u003c') + close;
  }));
  return file;
}

// All of one kind, which never repeats.
function millionDots(view) {
  const rows = 2000, each = 500;
  const fill = (to) => packed('f32', Float32Array.from({ length: rows * each }, () => to * Math.random() ** 2));
  const first = packed('i32', Int32Array.from({ length: rows + 1 }, (_, i) => i * each));
  const empty = packed('f64', new Float64Array(0));
  const [speed, phase, ...others] = view.things.numbers;
  Object.assign(speed, { rough: fill(speed.high), exact: empty, first });
  Object.assign(phase, { rough: fill(6), exact: empty, first });
  for (const number of others) number.exact = packed('f64', Float64Array.from({ length: rows }, (_, i) => 15 + (105 * i) / (rows - 1)));
  Object.assign(view.things, { kind: packed('i32', new Int32Array(rows)), orbit: packed('i32', new Int32Array(rows)), more: {} });
  const [dots] = view.rows[0][0].series.filter(({ title }) => title === 'sweep: not periodic');
  dots.runs = { thing: packed('i32', Int32Array.from({ length: rows }, (_, i) => i)), count: packed('i32', new Int32Array(rows).fill(each)) };
  view.rows[0][0].series = [dots];
  view.layouts = [];
}

// How long that takes is told, not asserted: it is the machine's.
test('a million dots are drawn, and answer the pointer', async () => {
  const file = changed('million dots.html', millionDots);
  const { page, wrong, close } = await openPage(browser, file);
  const shown = await page.evaluate(() => performance.getEntriesByName('drawn')[0].startTime);
  assert.ok(await pixelsOf(page, '#dots') > 50000);
  const begin = Date.now();
  await page.mouse.move(700, 400);
  assert.match(await text(page, '#hover'), /sweep/);
  console.log(`a million dots: drawn after ${Math.round(shown)} ms, hover ${Date.now() - begin} ms`);
  assert.deepEqual(wrong, []);
  await close();
});

inPage('exponents stand below, and are zoomed along', exponents, async (page) => {
  const height = (await (await page.$('#chart')).boundingBox()).height;
  const strip = () => page.$eval('#dots', (canvas, part) => {
    const top = Math.round(part * canvas.height);
    const { data } = canvas.getContext('2d').getImageData(0, top, canvas.width, canvas.height - top - 60);
    let indigo = 0;  // #332288
    for (let i = 0; i < data.length; i += 4) if (data[i] < 70 && data[i + 1] < 60 && data[i + 2] > 110 && data[i + 3] > 200) ++indigo;
    return indigo;
  }, 1 - 172 / height);
  const before = await strip();
  assert.ok(before > 100, `${before}`);
  await page.click('#zoom-in');
  await settled(page);
  const zoomed = await strip();
  assert.ok(zoomed > 0 && zoomed < before, `${zoomed} of ${before}`);
});
