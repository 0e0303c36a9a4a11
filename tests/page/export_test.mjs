// What the pages save: the picture as PNG, the numbers in view as CSV.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { settled } from './browser.mjs';
import { folder, imageOf, inPage, pageOf, range, rowsOf, saved, scene, written } from './pages.mjs';

const kFrequency = 'forcing frequency Ω (rad/s)', kSpeed = 'impact speed (m/s)';
const oneMode = scene('05_wagg_one_mode.toml');
const diagram = pageOf('swept.html', 'diagram', oneMode, '--parameter', 'forcing.frequency', '--from', '15', '--to', '120',
  '--points', '100', '--direction', 'down', '--set', 'stop.gap=1.05e-3', '--branches', 'all', '--out', join(folder, 'swept'));
const orbits = pageOf('orbits.html', 'orbit', oneMode, '--set', 'forcing.frequency=40', '--set', 'stop.gap=0.01');
const motion = pageOf('run.html', 'simulate', scene('02_wagg_momentum.toml'), '--duration', '1', '--energy', '--record', 'samples',
  '--out', join(folder, 'run'));
const basins = pageOf('cells.html', 'map', scene('04_impact_oscillator.toml'), '--set', 'forcing.frequency=1.6', '--set', 'stop.gap=0.5',
  '--set', 'forcing.amplitude=0.5', '--set', 'initial.q=[0.0]', '--parameter', 'initial.q.1', '--from', '-4', '--to', '0.4',
  '--points', '12', '--second', 'initial.qdot.1', '--second-from', '-4', '--second-to', '4', '--second-points', '9',
  '--out', join(folder, 'cells'));

const csvOf = async (page) => {
  const { name, bytes } = await saved(page, '#save-csv');
  assert.match(name, /\.csv$/);
  return rowsOf(bytes);
};
const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
const near = (a, b, part) => Math.abs(a - b) <= part * Math.max(Math.abs(a), Math.abs(b));

// As many numbers of both, and the same to a part of them.
function assertAlike(found, expected, part) {
  assert.equal(found.length, expected.length);
  assert.ok(found.length > 0);
  const [a, b] = [sorted(found), sorted(expected)];
  a.forEach((value, i) => assert.ok(near(value, b[i], part), `${value} is not ${b[i]}`));
}

inPage('the CSV of a diagram has the numbers of the run', diagram, async (page) => {
  const { name, bytes } = await saved(page, '#save-csv');
  assert.equal(name, 'swept.csv');
  const rows = rowsOf(bytes);
  assert.deepEqual(Object.keys(rows[0]), ['series', 'of', kFrequency, kSpeed]);
  const speeds = (list) => list.map((row) => Number(row[kSpeed]));
  assertAlike(speeds(rows.filter(({ series }) => series.startsWith('sweep'))),
    written('swept', 'sweep.csv').filter(({ speed }) => speed !== '').map(({ speed }) => Number(speed)), 1e-7);
  for (const { id, value, speed } of written('swept', 'special.csv')) {
    if (speed === '') continue;
    const row = rows.find(({ of }) => of === id);
    assert.ok(row && near(Number(row[kFrequency]), Number(value), 1e-12) && near(Number(row[kSpeed]), Number(speed), 1e-12), id);
  }
});

inPage('what is hidden or out of view is not saved, what is shown otherwise is', diagram, async (page) => {
  const series = (rows) => new Set(rows.map((row) => row.series));
  const before = await csvOf(page);
  assert.ok(series(before).has('stable') && series(before).has('sweep: not periodic'));
  await page.click('#legend button[data-type="stable"]');
  await page.click('#legend button[data-type="sweep: not periodic"]');
  const hidden = await csvOf(page);
  assert.ok(!series(hidden).has('stable') && !series(hidden).has('sweep: not periodic') && series(hidden).has('unstable'));
  await page.click('#zoom-in');
  await settled(page);
  const [low, high] = (await range(page)).match(/Ω from ([\d.]+) rad\/s to ([\d.]+) rad/).slice(1).map(Number);
  const seen = (await csvOf(page)).map((row) => Number(row[kFrequency]));
  assert.ok(seen.length > 10 && seen.length < hidden.length);
  assert.ok(seen.every((value) => value >= low - 0.01 && value <= high + 0.01), `${low} to ${high}`);
  await page.selectOption('#observable', 'phase');
  const [row] = await csvOf(page);
  assert.deepEqual(Object.keys(row), ['series', 'of', kFrequency, 'forcing phase of the impact (rad)']);
  await page.selectOption('#observable-scale', 'decibel');
  assert.ok(Object.keys((await csvOf(page))[0]).includes('forcing phase of the impact (dB re 1 rad)'));
});

inPage('the PNG has title, dots, lines, marks and legend', diagram, async (page) => {
  const { name, bytes } = await saved(page, '#save-png');
  assert.equal(name, 'swept.png');
  const image = await imageOf(page, bytes);
  const chart = await (await page.$('#chart')).boundingBox();
  assert.equal(image.width, Math.round(chart.width));
  assert.ok(image.height > chart.height + 60);
  const legend = image.height - 40;
  assert.ok(image.count('#1b1b1b', 0, 34) > 50, 'title');
  assert.ok(image.count('#000000', 56, legend) > 200, 'dots that repeat');
  assert.ok(image.count('#0072b2', 56, legend) > 100, 'stable');
  const purple = [image.count('#aa3377', 56, legend), image.count('#aa3377', legend)];
  assert.ok(purple[0] > 20 && purple[1] > 20, `${purple}`);
  assert.equal(image.at(3, 3), '#ffffff');
  await page.click('#legend button[data-type="period doubling (PD)"]');
  await settled(page);
  const without = await imageOf(page, (await saved(page, '#save-png')).bytes);
  assert.equal(without.count('#aa3377'), 0);
});

inPage('in the dark the PNG is dark', diagram, async (page) => {
  const image = await imageOf(page, (await saved(page, '#save-png')).bytes);
  assert.equal(image.at(3, 3), '#15181c');
}, { colorScheme: 'dark' });

inPage('the CSV of orbits has the curves that are shown', orbits, async (page) => {
  const rows = await csvOf(page);
  const [, , x, v, time, displacement] = Object.keys(rows[0]);
  assert.deepEqual([x, v, time, displacement], ['towards stop (mm)', 'velocity → stop (m/s)', 'time (ms)', 'displacement → stop (mm)']);
  // The largest displacement is the gap, 10 mm, that of an impact, in the plane and over time.
  const most = (name) => rows.reduce((largest, row) => Math.max(largest, row[name] === '' ? -Infinity : Number(row[name])), -Infinity);
  for (const name of [x, displacement]) assert.ok(near(most(name), 10, 1e-6), `${most(name)}`);
  assert.ok(rows.some((row) => Number(row[v]) < 0));
  const seen = async () => [...new Set((await csvOf(page)).map(({ series }) => series).filter((name) => name.startsWith('orbit')))];
  const [first, second] = await seen();
  assert.match(`${first}; ${second}`, /^orbit 1, \(1,1\) stable, v = [\d.]+ m\/s; orbit 2, \(1,1\) unstable, v = [\d.]+ m\/s$/);
  await page.click(`#legend button[data-type="${first}"]`);
  assert.deepEqual(await seen(), [second]);
});

inPage('the CSV of a motion has its samples and impacts', motion, async (page) => {
  const rows = await csvOf(page);
  const [time, displacement] = Object.keys(rows[0]);
  assert.equal(time, 'time (s)');
  assert.equal(displacement, 'displacement towards the stop (mm)');
  const before = Object.keys(rows[0]).find((name) => name.startsWith('velocity before the impact'));
  const impacts = written('run', 'events.csv').filter(({ kind }) => kind === 'impact').map(({ speed }) => Number(speed));
  assertAlike(rows.filter((row) => row[before] !== '').map((row) => Number(row[before])), impacts, 1e-6);
  const energies = rows.filter((row) => row['energy (µJ)'] !== '' && row['energy (µJ)'] !== undefined);
  assert.ok(energies.length > 100);
  await page.click('#legend button[data-type="impact"]');
  assert.ok(!Object.keys((await csvOf(page))[0]).some((name) => name.startsWith('velocity before')));
});

inPage('the CSV of a map has the cells that are shown', basins, async (page) => {
  const rows = await csvOf(page);
  assert.equal(rows.length, 12 * 9);
  const cells = written('cells', 'map.csv');
  assert.equal(cells.length, rows.length);
  await page.selectOption('#observable', 'speed');
  const told = await csvOf(page);
  const name = Object.keys(told[0]).at(-1);
  assert.equal(name, 'speed of the fastest impact (m/s)');
  assertAlike(told.filter((row) => row[name] !== '' && Number(row[name]) > 0).map((row) => Number(row[name])),
    cells.filter(({ peak_speed }) => Number(peak_speed) > 0).map(({ peak_speed }) => Number(peak_speed)), 1e-6);
  await page.selectOption('#observable', 'attractor');
  await page.click('#legend button:text("no impact")');
  const left = await csvOf(page);
  assert.ok(left.length > 0 && left.length < rows.length && left.every(({ of }) => !of.startsWith('no impact')));
});

inPage('the PNG of a map has its cells, and its bar of colours', basins, async (page) => {
  await page.selectOption('#observable', 'impacts');
  const image = await imageOf(page, (await saved(page, '#save-png')).bytes);
  assert.ok(image.count('#fde725', 56, image.height - 60) > 5000, 'cells of one impact');
  const bar = new Set(Array.from({ length: image.width }, (_, x) => image.at(x, image.height - 45)));
  assert.ok(bar.size > 100, `${bar.size} colours in the bar`);
});
