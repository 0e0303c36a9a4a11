// The page of a map, in a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, pixelsOf, settled } from './browser.mjs';
import { again, browser, folder, ground, inPage, isShown, packed, pageOf, range, scene, text } from './pages.mjs';

const basins = pageOf('basins.html', 'map', scene('04_impact_oscillator.toml'), '--set', 'forcing.frequency=1.6',
  '--set', 'stop.gap=0.5', '--set', 'forcing.amplitude=0.5', '--set', 'initial.q=[0.0]', '--parameter', 'initial.q.1',
  '--from', '-4.05', '--to', '0.75', '--points', '49', '--second', 'initial.qdot.1', '--second-from', '-4',
  '--second-to', '4', '--second-points', '41', '--exponents', '50');
// From high to low, with frequencies upright.
const plane = pageOf('plane.html', 'map', scene('05_wagg_one_mode.toml'), '--parameter', 'stop.gap', '--from', '2e-3',
  '--to', '0.5e-3', '--points', '16', '--second', 'forcing.frequency', '--second-from', '20', '--second-to', '110',
  '--second-points', '31', '--show', 'speed', '--locus', 'PD,LP', '--slices', '2', '--out', join(folder, 'plane'));

// Where the middle of a cell is on the screen, by its column and row of so many, as seen.
async function placeOfCell(page, [column, columns], [row, rows]) {
  const box = await (await page.$('#chart')).boundingBox();
  const left = box.x + 92, right = box.x + box.width - 20, top = box.y + 14, bottom = box.y + box.height - 50;
  return { x: left + ((column + 0.5) / columns) * (right - left), y: bottom - ((row + 0.5) / rows) * (bottom - top) };
}

// The colour that is drawn there.
function colourAt(page, { x, y }) {
  return page.$eval('#dots', (canvas, [px, py]) => {
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    const { data } = canvas.getContext('2d').getImageData((px - box.x) * scale, (py - box.y) * scale, 1, 1);
    return `#${[...data.slice(0, 3)].map((part) => part.toString(16).padStart(2, '0')).join('')}${data[3] === 0 ? ' none' : ''}`;
  }, [x, y]);
}

const toldNumbers = (page) => page.$$eval('#orbit-numbers tr', (rows) => Object.fromEntries(
  rows.map((row) => [row.cells[0].textContent, row.cells[1].textContent])));

inPage('a map is drawn in the colours of the picture', basins, async (page) => {
  assert.equal(await text(page, 'h1'), 'Basins of attraction');
  const titles = await page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
  assert.deepEqual(titles, ['(1,1)', 'no impact', 'no start']);
  assert.ok(await pixelsOf(page, '#dots') > 100_000);
  assert.equal(await colourAt(page, await placeOfCell(page, [0, 49], [40, 41])), '#77aadd');  // (1,1)
  assert.equal(await colourAt(page, await placeOfCell(page, [39, 49], [20, 41])), '#c4e4f2');  // rests at the start
  assert.equal(await colourAt(page, await placeOfCell(page, [48, 49], [20, 41])), '#e8e8e8');
  assert.match(await range(page), /^Map of the attractor: dq₁\/dt at the start from .* over q₁ at the start from −4\.1 kg\^½ m to 0\.8 kg\^½ m/);
});

inPage('the pointer is told the cell under it', basins, async (page) => {
  const place = await placeOfCell(page, [10, 49], [35, 41]);
  await page.mouse.move(place.x, place.y);
  const told = await text(page, '#hover');
  assert.match(told, /^\(1,1\)q₁ at the start−3\.05 kg\^½ mdq₁\/dt at the start3 kg\^½ m\/simpacts a forcing period1largest exponent−[\d.]+ 1\/s/);
  assert.match(told, /speed of the fastest impact1\.\d+ m\/s/);
  await page.mouse.move(5, 5);
  assert.ok(!await isShown(page, '#hover'));
});

inPage('what is shown can be switched, with a bar of its colours', basins, async (page) => {
  const names = await page.$$eval('#observable option', (list) => list.map((option) => option.textContent));
  assert.deepEqual(names, ['attractor', 'impacts a forcing period', 'largest exponent', 'speed of the fastest impact',
    'part of the time at rest on a stop']);
  const place = await placeOfCell(page, [39, 49], [20, 41]);
  await page.selectOption('#observable', 'impacts');
  assert.ok(await isShown(page, '#bar') && !await isShown(page, '#legend'));
  assert.match(await text(page, '#bar'), /^impacts a forcing period00\.250\.50\.751no number$/);
  assert.equal(await colourAt(page, place), '#440154');  // none of 0 to 1
  assert.equal(await colourAt(page, await placeOfCell(page, [10, 49], [35, 41])), '#fde725');
  await page.selectOption('#observable', 'attractor');
  assert.ok(!await isShown(page, '#bar') && await isShown(page, '#legend'));
});

inPage('the legend hides by attractor', basins, async (page) => {
  const all = await pixelsOf(page, '#dots');
  await page.click('#legend button:text("no impact")');
  assert.ok(await pixelsOf(page, '#dots') < all);
  assert.match(await colourAt(page, await placeOfCell(page, [39, 49], [20, 41])), /none/);
  await page.click('#legend button:text("no impact")');
  assert.equal(await pixelsOf(page, '#dots'), all);
});

inPage('wheel and buttons zoom', basins, async (page) => {
  const whole = await range(page);
  const place = await placeOfCell(page, [39, 49], [20, 41]);
  await page.mouse.move(place.x, place.y);
  await page.mouse.wheel(0, -500);
  await settled(page);
  assert.notEqual(await range(page), whole);
  assert.equal(await colourAt(page, place), '#c4e4f2');  // what is under the pointer stays there
  assert.match(await text(page, '#hover'), /^(no impact.*)?$/);
  await page.click('#zoom-reset');
  assert.equal(await range(page), whole);
});

inPage('a click opens the cell, and its command follows it', basins, async (page) => {
  const place = await placeOfCell(page, [10, 49], [35, 41]);
  await page.mouse.click(place.x, place.y);
  await settled(page);
  assert.equal(await text(page, '#orbit-title'), '(1,1)');
  for (const picture of ['series', 'portrait', 'circle']) assert.ok(await pixelsOf(page, `#orbit-${picture} canvas`) > 1000, picture);
  assert.match(await text(page, '#orbit-facts'), /^stable · largest multiplier 0\.\d+ in modulus/);
  assert.equal(await text(page, '#orbit-remark'), '');  // all starts in a basin lead there
  const numbers = await toldNumbers(page);
  const command = await text(page, '#orbit-command');
  assert.match(command, / --set 'initial\.q=\[-3\.0[45]\d*\]' --set 'initial\.qdot=\[3\.0*\d*\]' --periods 1000 --plot cell\.html$/);
  const impacts = again(command).events.filter(({ kind }) => kind === 'impact').slice(-3);
  for (const { speed } of impacts) assert.ok(Math.abs(speed - Number.parseFloat(numbers['speed of the fastest impact'])) < 2e-6 * speed, `${speed}`);
  // One impact each period, at the phase that the panel lists.
  const [row] = await page.$$eval('#orbit-impacts tbody tr', (rows) => rows.map(({ cells }) => [...cells].map((cell) => Number(cell.textContent))));
  assert.ok(Math.abs(row[2] - impacts[0].speed) < 2e-5 * row[2], `${row}`);
  assert.ok(Math.abs(2 * Math.PI * row[0] - impacts[0].phase) < 1e-4, `${row} ${impacts[0].phase}`);
  assert.match(readFileSync(join(folder, 'cell.html'), 'utf8'), /^<!doctype html>/);
  await page.click('#orbit-close');
  assert.ok(!await isShown(page, '#orbit'));
});

inPage('a cell without a motion says why', basins, async (page) => {
  await page.click('#tables button:text("no start")');
  assert.match(await text(page, '#orbit-remark'), /beyond/);
  for (const picture of ['series', 'portrait', 'circle']) assert.ok(!await isShown(page, `#orbit-${picture}`));
  assert.equal(await text(page, '#orbit-impacts'), '');
});

inPage('a cell of what never repeats says what its numbers are of', plane, async (page) => {
  if (!await page.$eval('#tables details', (details) => details.open)) await page.click('#tables summary >> nth=0');
  await page.click('#tables button:text("not periodic")');
  assert.match(await text(page, '#orbit-remark'), /repeats no pattern.* periods\. (The page keeps not every motion.* )?The numbers are those of the last 100 forcing periods/);
  assert.ok(await pixelsOf(page, '#orbit-series canvas') > 1000);
  assert.ok(!await isShown(page, '#orbit-circle'));
});

inPage('every kind of cells that have a motion shows one', plane, async (page) => {
  if (!await page.$eval('#tables details', (details) => details.open)) await page.click('#tables summary >> nth=0');
  const buttons = await page.$$('#tables details >> nth=0 >> button');
  assert.ok(buttons.length > 5);
  for (const button of buttons) {
    await button.click();
    assert.ok(await pixelsOf(page, '#orbit-portrait canvas') > 500, await button.textContent());
  }
});

// The points of a kind of locus as loci.csv has them, SI.
function tracedPoints(kind) {
  const [head, ...rows] = readFileSync(join(folder, 'plane', 'loci.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
  const column = (name) => head.indexOf(name);
  return rows.filter((row) => row[column('label')] === kind && row[column('admissible')] === '1')
    .map((row) => [Number(row[column('value')]), Number(row[column('second')])]);
}

// How many pixels about a place of the chart are not the cells', which lie below it.
function drawnAbout(page, { x, y }) {
  return page.$eval('#chart canvas', (canvas, [px, py]) => {
    const box = canvas.getBoundingClientRect();
    const scale = canvas.width / box.width;
    const { data } = canvas.getContext('2d').getImageData((px - box.x - 4) * scale, (py - box.y - 4) * scale, 9, 9);
    return data.filter((value, i) => i % 4 === 3 && value > 0).length;
  }, [x, y]);
}

inPage('loci lie over the cells, and the legend hides them', plane, async (page) => {
  const titles = await page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
  assert.ok(titles.includes('period doubling (PD)'), `${titles}`);  // though colours tell speeds
  const box = await (await page.$('#chart')).boundingBox();
  // As much of a cell's half beyond the first and the last value; the upper axis takes nothing here.
  const place = ([gap, frequency]) => ({
    x: box.x + 92 + ((gap - 0.45e-3) / 1.6e-3) * (box.width - 112),
    y: box.y + box.height - 50 - ((frequency - 18.5) / 93) * (box.height - 64),
  });
  const points = tracedPoints('PD').filter(([gap, frequency]) => gap > 0.5e-3 && gap < 2e-3 && frequency > 20 && frequency < 110);
  assert.ok(points.length > 20, `${points.length}`);
  for (const point of points) assert.ok(await drawnAbout(page, place(point)) > 8, `${point}`);
  await page.click('#legend button:text("period doubling (PD)")');
  await settled(page);
  let left = 0;
  for (const point of points) left += await drawnAbout(page, place(point)) > 8;
  assert.ok(left < 0.2 * points.length, `${left}`);
});

inPage('keys go from cell to cell and open one', plane, async (page) => {
  assert.equal(await text(page, 'h1'), 'Map of attractors');
  assert.equal(await page.$eval('#observable', (select) => select.value), 'speed');
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  const gap = async () => Number((await text(page, '#hover')).match(/gap([\d.]+) mm/)[1]);
  const first = await gap();
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs((await gap()) - first - 0.1) < 1e-6, 'to the right is up, though values come falling');
  // To where the motion repeats, so that the command comes to the same whatever its rounding.
  for (const key of ['ArrowDown', 'ArrowLeft']) for (let i = 0; i < 4; ++i) await page.keyboard.press(key);
  await page.keyboard.press('Enter');
  const numbers = await toldNumbers(page);
  assert.notEqual(numbers['impacts a forcing period'], '0', JSON.stringify(numbers));
  const run = again(await text(page, '#orbit-command'));
  const speeds = run.events.filter(({ kind }) => kind === 'impact').slice(-1).map(({ speed }) => speed);
  assert.ok(speeds[0] <= Number.parseFloat(numbers['speed of the fastest impact']) * (1 + 1e-6), `${speeds}`);
  await page.keyboard.press('Escape');
  assert.ok(!await isShown(page, '#orbit'));
});

test('on dark ground what never repeats and what has no motion change places', async () => {
  const dark = await openPage(browser, basins(), { colorScheme: 'dark' });
  const none = await placeOfCell(dark.page, [48, 49], [20, 41]);
  assert.equal(await colourAt(dark.page, none), '#262b31');
  await dark.page.click('#theme');
  assert.equal(await colourAt(dark.page, none), '#e8e8e8');
  assert.equal(await ground(dark.page), 'rgb(255, 255, 255)');
  assert.deepEqual(dark.wrong, []);
  await dark.close();
});

// How long that takes is told, not asserted: it is the machine's.
test('a million cells are drawn, and answer the pointer', async () => {
  const side = 1000, cells = side * side;
  const file = join(folder, 'million cells.html');
  writeFileSync(file, readFileSync(basins(), 'utf8').replace(/(id="view">)(.*?)(<\/script>)/s, (_, open, json, close) => {
    const view = JSON.parse(json);
    const panel = view.rows[0][0];
    for (const [name, low, high] of [['columns', -4, 0.8], ['rows', -4, 4]])
      panel.cells[name] = packed('f64', Float64Array.from({ length: side }, (__, i) => low + ((high - low) * i) / (side - 1)));
    panel.cells.ground = view.things.kind = packed('u8', Uint8Array.from({ length: cells }, () => Math.floor(3 * Math.random())));
    view.cells.messages = null;
    for (const number of view.things.numbers) number.rough = packed('f32', Float32Array.from({ length: cells }, Math.random));
    return open + JSON.stringify(view).replaceAll('<', '\\u003c') + close;
  }));
  const { page, wrong, close } = await openPage(browser, file);
  const shown = await page.evaluate(() => performance.getEntriesByName('drawn')[0].startTime);
  assert.ok(await pixelsOf(page, '#dots') > 100_000);
  const begin = Date.now();
  await page.mouse.move(700, 400);
  assert.match(await text(page, '#hover'), /at the start/);
  const hovered = Date.now();
  await page.selectOption('#observable', 'speed');
  console.log(`a million cells: drawn after ${Math.round(shown)} ms, hover ${hovered - begin} ms, shown otherwise ${Date.now() - hovered} ms`);
  assert.deepEqual(wrong, []);
  await close();
});
