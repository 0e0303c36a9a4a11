// The pages of fit, cost, compare and of loci with regions, in a browser: each from its command.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { pixelsOf, settled } from './browser.mjs';
import { again, folder, inPage, isShown, pageOf, range, rowsOf, saved, scene, text, written } from './pages.mjs';

const oneMode = scene('05_wagg_one_mode.toml');
const plane = ['--parameter', 'forcing.frequency', '--from', '20', '--to', '100', '--second', 'stop.gap', '--second-from', '0.5e-3',
  '--second-to', '2e-3'];
const measured = (name) => scene(join('..', 'measurements', name));
const fit = pageOf('fit.html', 'fit', measured('restitution.toml'), measured('restitution.csv'), '--out', join(folder, 'fit'));
const motions = pageOf('motions.html', 'compare', scene('02_wagg_momentum.toml'), '--against', 'stop.impulse="collocation"',
  '--duration', '2', '--last', '0.5', '--out', join(folder, 'motions'));
const agreement = pageOf('agreement.html', 'compare', oneMode, '--against', 'stop.restitution=0.7', ...plane, '--points', '9',
  '--second-points', '7', '--periods', '200', '--out', join(folder, 'agreement'));
const loci = pageOf('loci.html', 'continue', oneMode, '--locus', 'PD,LP,GR', ...plane, '--slices', '2', '--out', join(folder, 'loci'));
const regions = pageOf('regions.html', 'continue', oneMode, '--locus', 'PD', ...plane, '--slices', '1', '--regions', '8',
  '--out', join(folder, 'regions'));
const sensitivity = pageOf('sensitivity.html', 'compare', scene('20_yigit_sensitivity.toml'), '--sensitivity', '--duration', '0.2',
  '--parameter', 'stop.spring.damping.coefficient', '--from', '0', '--to', '1000', '--points', '3', '--out', join(folder, 'sensitivity'));
const cost = pageOf('cost.html', 'cost', scene('04_impact_oscillator.toml'), '--out', join(folder, 'cost'));

const titles = (page) => page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
const csvOf = async (page) => rowsOf((await saved(page, '#save-csv')).bytes);

// Where a place of the plane is on the screen, by the whole range of its axes, SI.
async function placeOf(page, [x, y], [low, high], [bottom, top], upper) {
  const box = await (await page.$('#chart')).boundingBox();
  return {
    x: box.x + 92 + ((x - low) / (high - low)) * (box.width - 112),
    y: box.y + box.height - 50 - ((y - bottom) / (top - bottom)) * (box.height - 50 - upper),
  };
}

inPage('a fit is a chart of its values, residuals and parameters', fit, async (page) => {
  assert.deepEqual((await titles(page)).slice(0, 2), ['measured', 'fitted']);
  const rows = (await csvOf(page)).filter(({ series }) => series === 'measured');
  const data = written('fit', 'fit.csv');
  const name = Object.keys(rows[0]).find((column) => column.startsWith('restitution'));
  assert.equal(rows.filter((row) => row[name] !== '').length, data.length);
  const measured = Object.keys(data[0]).find((column) => column.includes('measured'));
  const sum = (list, column) => list.reduce((total, row) => total + Number(row[column] || 0), 0);
  assert.ok(Math.abs(sum(rows, name) - sum(data, measured)) < 1e-9 * sum(data, measured));
  const [parameter] = written('fit', 'parameters.csv');
  const told = await text(page, '#tables');
  assert.match(told, /Fitted parameters/);
  assert.ok(told.includes(Number(parameter.value).toPrecision(6).slice(0, 6)), `${parameter.value} in ${told}`);
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, '#hover'), /^measured/);
});

inPage('two motions stand in one chart', motions, async (page) => {
  assert.match(await range(page), /displacement.* over time from 1\.49\d* s to 2\.01 s/);
  assert.equal((await titles(page)).filter((title) => /collocation|scene/.test(title)).length, 2);
  const told = await text(page, '#tables');
  assert.match(told, /Motionsmotionsettles onfirst impact \(s\)|Motionsmotionsettles onfirst impact \(ms\)/);
  const all = await pixelsOf(page, '#chart canvas');
  await page.click('#legend button >> nth=0');
  await settled(page);
  assert.ok(await pixelsOf(page, '#chart canvas') < all);
});

inPage('a map of a comparison has its cells, and its command compares them', agreement, async (page) => {
  assert.match(await text(page, 'h1'), /against stop\.restitution=0\.7/);
  const cells = written('agreement', 'comparison.csv');
  const rows = await csvOf(page);
  assert.equal(rows.length, 63);
  assert.equal(cells.length, 63);
  const names = await page.$$eval('#observable option', (list) => list.map((option) => option.textContent));
  assert.ok(names.length === 8 && names[0] === 'attractor', `${names}`);
  await page.selectOption('#observable', 'displacement');
  const column = Object.keys(cells[0]).find((name) => name.startsWith('displacement'));
  const [name] = Object.keys((await csvOf(page))[0]).slice(-1);
  const found = (await csvOf(page)).map((row) => row[name]).filter((value) => value !== '').map(Number).sort((a, b) => a - b);
  const expected = cells.map((cell) => cell[column]).filter((value) => value !== '').map(Number).sort((a, b) => a - b);
  assert.equal(found.length, expected.length);
  found.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= 1e-6 * Math.abs(expected[i]) + 1e-12, `${value} is not ${expected[i]}`));
  await page.selectOption('#observable', 'attractor');
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  const command = await text(page, '#orbit-command');
  assert.match(command, /^graze compare .* --against stop\.restitution=0\.7 --set forcing\.frequency=\d+.* --set stop\.gap=[\d.e-]+ --plot cell\.html$/);
  assert.equal(again(command).outcome, 'compared');
});

inPage('loci are drawn, pointed at and named', loci, async (page) => {
  assert.equal(await text(page, 'h1'), 'Loci of special points');
  const legend = await titles(page);
  for (const title of ['period doubling (PD)', 'grazing (GR)']) assert.ok(legend.includes(title), `${legend}`);
  assert.ok(!await isShown(page, '#observables'));
  const points = written('loci', 'loci.csv').filter((row) => row.label === 'PD' && row.admissible === '1');
  const at = points[Math.floor(points.length / 2)];
  const place = await placeOf(page, [Number(at.value), Number(at.second)], [20, 100], [0.5e-3, 2e-3], 52);
  await page.mouse.move(place.x, place.y);
  const told = await text(page, '#hover');
  assert.match(told, /^(period doubling \(PD\)|[A-Z0-9]+-\d+: .*)forcing frequency Ω[\d.]+ rad\/sgap[\d.]+ mm$/);
  const special = written('loci', 'special.csv');
  assert.ok(special.length > 0);
  const named = await page.$$eval('#tables tbody tr', (list) => list.map((row) => row.cells[0].textContent));
  for (const { id } of special) assert.ok(named.some((title) => title.startsWith(`${id}: `)), id);
  const one = special[0];
  const mark = await placeOf(page, [Number(one.value), Number(one.second)], [20, 100], [0.5e-3, 2e-3], 52);
  await page.mouse.move(mark.x, mark.y);
  assert.match(await text(page, '#hover'), new RegExp(`: [a-z0-9: -]+, on locus \\d+ \\((PD|LP|GR)\\)`));
  const before = await pixelsOf(page, '#chart canvas');
  await page.click('#labels');
  await settled(page);
  const bare = await pixelsOf(page, '#chart canvas');
  assert.ok(bare < before, `${bare} of ${before}`);
  await page.click('#legend button:text("period doubling (PD)")');
  await settled(page);
  assert.ok(await pixelsOf(page, '#chart canvas') < bare);
});

inPage('regions are cells under the loci, named by what is stable there', regions, async (page) => {
  assert.equal(await text(page, 'h1'), 'Stable motions and loci');
  const places = written('regions', 'regions.csv');
  assert.equal(places.length, 64);
  const rows = (await csvOf(page)).filter(({ series }) => series === 'cell');
  assert.equal(rows.length, 64);
  const count = (list, key, name) => list.filter((row) => row[key] === name).length;
  const column = Object.keys(places[0]).find((name) => ['stable', 'label', 'motions'].includes(name));
  for (const name of new Set(places.map((row) => row[column])))
    assert.equal(count(rows, 'of', name || 'nothing stable found'), count(places, column, name), name);
  assert.ok(await pixelsOf(page, '#dots') > 100_000);
  if (!await page.$eval('#tables details', (details) => details.open)) await page.click('#tables summary >> nth=0');
  await page.click('#tables button >> nth=0');
  const command = await text(page, '#orbit-command');
  assert.match(command, /^graze orbit .* --set forcing\.frequency=\d+.* --period 1$/);
  const title = await text(page, '#orbit-title');
  const { outcome, orbits } = again(command);
  // What is stable there is among what the command finds, where it is an orbit with impacts.
  if (/^\(1,1\)/.test(title)) assert.ok(outcome === 'found' && orbits.some(({ period, impacts, stable }) => period === 1 && impacts === 1 && stable));
});

inPage('sensitivities are curves over the parameter', sensitivity, async (page) => {
  const rows = await csvOf(page);
  const table = written('sensitivity', 'sensitivity.csv');
  const of = (column, list) => list.map((row) => row[column]).filter((value) => value !== '' && value !== undefined).map(Number).sort((a, b) => a - b);
  const s1 = Object.keys(rows[0]).filter((name) => /^s(₁|_?1)/.test(name));
  const expected = Object.keys(table[0]).filter((name) => name.startsWith('s1')).flatMap((name) => of(name, table)).sort((a, b) => a - b);
  const found = s1.flatMap((name) => of(name, rows)).sort((a, b) => a - b);
  assert.ok(expected.length >= 3);
  assert.equal(found.length, expected.length);
  assert.ok(expected.some((value) => value !== 0));
  // In per cent.
  found.forEach((value, i) => assert.ok(Math.abs(value - 100 * expected[i]) <= 1e-9 * Math.abs(value) + 1e-12, `${value} is not ${expected[i]}`));
  assert.match(await text(page, '#tables'), /Largest sensitivitiesprobe\|s1\| \(%\)\|s2\| \(%\)1 /);
});

inPage('costs are lines over logarithmic axes', cost, async (page) => {
  assert.match(await range(page), /^largest error of an impact time from .* µs to .* µs over computing time per forcing period from .* [mµ]?s to /);
  const legend = await titles(page);
  const flows = new Set(written('cost', 'costs.csv').map(({ flow }) => flow));
  assert.ok(flows.size > 2);
  for (const flow of flows) assert.ok(legend.some((title) => title.includes(flow)), `${flow} in ${legend}`);
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, '#hover'), /computing time per forcing period[\d.]+(·10[⁻\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)? [mµ]?slargest error/);
  const told = await page.$$eval('#tables details:first-of-type tbody tr', (list) => list.length);
  assert.equal(told, written('cost', 'costs.csv').length);
});
