// The page of a simulated motion, in a browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { openPage, pixelsOf, placeOf, settled } from './browser.mjs';
import { again, browser, folder, ground, inPage, isShown, pageOf, program, range, rowsOf, scene, text } from './pages.mjs';

const sticks = pageOf('sticks.html', 'simulate', scene('02_wagg_momentum.toml'), '--duration', '1', '--energy');
const supports = pageOf('two supports.html', 'simulate', scene('10_two_supports.toml'), '--duration', '0.3');
const far = pageOf('far.html', 'simulate', scene('07_two_stops.toml'), '--duration', '1', '--set', 'stop.2.gap=0.3');
const ball = pageOf('ball.html', 'simulate', scene('06_bouncing_ball.toml'), '--duration', '1');

// The rows of the samples of the run of `sticks` at a rate.
async function recordedAt(rate) {
  const out = join(folder, 'recorded');
  execFileSync(program, ['simulate', scene('02_wagg_momentum.toml'), '--duration', '1', '--record', 'samples',
    '--sample-rate', String(rate), '--out', out, '--quiet'], { stdio: 'ignore' });
  return rowsOf(readFileSync(join(out, 'samples.csv')));
}

async function places(page) {
  const box = await (await page.$('#chart')).boundingBox();
  const left = box.x + 92, right = box.x + box.width - 20;
  return { at: (part) => left + part * (right - left), top: box.y + 60, left, right };
}

inPage('a motion is drawn, with impacts, stuck phase, force and energy', sticks, async (page) => {
  assert.equal(await text(page, 'h1'), 'Motion');
  assert.match(await range(page), /^displacement towards the stop from .* over time from 0 s to 1 s; velocity towards the stop from .*; contact force from .*; energy, work from /);
  assert.ok(await pixelsOf(page, '#chart canvas') > 5000);
  assert.ok(await pixelsOf(page, '#orbit-portrait canvas') > 500);
  const titles = await page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
  assert.deepEqual(titles, ['impact', 'stuck', 'behind the stop', 'energy', 'work of forcing', 'work of damping', 'work of impacts']);
  assert.match(await text(page, '#orbit-facts'), /^0 s to 1 s · 82 impacts$/);
});

// The stop of this scene stands below the tip: what goes towards it is minus u.
inPage('the beam bends as its tip moves, and plays', sticks, async (page) => {
  assert.ok(await isShown(page, '#beam'));
  const tip = async (k) => {
    await page.$eval('#beam input', (slider, to) => { slider.value = to; slider.dispatchEvent(new Event('input')); }, k);
    const [, time, u] = /^t = ([\d.]+) s, tip at (−?[\d.e·⁻⁰¹²³⁴⁵⁶⁷⁸⁹−]+) mm$/.exec(await text(page, '#beam output'));
    return { time: Number(time), u: Number(u.replace('−', '-')) };
  };
  // The same moments by the table of a run that records them, 400 samples a forcing period.
  const rate = 400 * 28.3 / (2 * Math.PI);
  const rows = await recordedAt(rate);
  for (const k of [100, 700, 1500]) {
    const { time, u } = await tip(k);
    const row = rows[k];
    assert.ok(Math.abs(time - Number(row.time)) < 1e-5, `${time} ${row.time}`);
    const expected = 1e3 * (Number(row.gap1) - 1.05e-3);  // mm
    assert.ok(Math.abs(u - expected) < 1e-3 * Math.abs(expected) + 1e-5, `${u} ${expected}`);
  }
  const drawn = () => page.$eval('#beam path[stroke-width="3"]', (path) => path.getAttribute('d'));
  const before = await drawn();
  await page.click('#beam button');
  await page.waitForFunction((last) => document.querySelector('#beam path[stroke-width="3"]').getAttribute('d') !== last, before);
  await page.click('#beam button');
  assert.equal(await text(page, '#beam button'), 'Play');
});

inPage('what has no length has no beam', ball, async (page) => {
  assert.ok(!await isShown(page, '#beam'));
});

inPage('the pointer is told the moment under it', sticks, async (page) => {
  const { at, top } = await places(page);
  await page.mouse.move(at(0.45), top);
  const told = await text(page, '#hover');
  assert.match(told, /^0\.4[45]\d* sdisplacement towards the stop−?[\d.]+ mmvelocity towards the stop−?[\d.]+ m\/senergy[\d.]+ µJwork of forcing/);
  assert.ok(await isShown(page, '#cursor') && await isShown(page, '#ring'));
  await page.mouse.move(5, 5);
  assert.ok(!await isShown(page, '#hover') && !await isShown(page, '#cursor'));
});

inPage('wheel, rectangle, buttons and keys zoom in time', sticks, async (page) => {
  const whole = await range(page);
  const { at, top } = await places(page);
  await page.mouse.move(at(0.5412895), top);
  for (let i = 0; i < 6; ++i) {
    await page.mouse.wheel(0, -500);
    await settled(page);
  }
  const [from, to] = (await range(page)).match(/over time from ([\d.]+) s to ([\d.]+) s/).slice(1).map(Number);
  assert.ok(from < 0.5412895 && to > 0.5412895 && to - from < 0.7, `${from} to ${to}`);
  const listed = await page.$$eval('#orbit-impacts tbody tr', (rows) => rows.map((row) => Number(row.cells[0].textContent)));
  assert.ok(listed.length > 0 && listed.every((time) => time >= from - 1e-4 && time <= to + 1e-4), `${listed}`);
  const seen = async () => {
    await settled(page);
    return range(page);
  };
  await page.click('#zoom-reset');
  assert.equal(await seen(), whole);
  await page.click('#zoom-in');
  assert.notEqual(await seen(), whole);
  await page.focus('#chart');
  await page.keyboard.press('0');
  assert.equal(await seen(), whole);
  // The stuck phase of the scene: from 0.5412895 to 0.5434528 s, with 0.101119 N at its beginning.
  await page.click('#zoom-box');
  await page.mouse.move(at(0.53), top);
  await page.mouse.down();
  await page.mouse.move(at(0.55), top + 40, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  await page.mouse.move(at(0.6), top);
  assert.match(await text(page, '#hover'), /contact force\d{2}\.\d+ mN/);
});

inPage('a click keeps a moment, keys go from impact to impact', sticks, async (page) => {
  const { at, top } = await places(page);
  await page.mouse.click(at(0.773648536), top);
  await settled(page);
  const numbers = await text(page, '#orbit-numbers');
  assert.match(numbers, /^at0\.7736485 s: impactvelocity before0\.0642\d+ m\/svelocity after−0\.0514\d+ m\/s/);
  await page.keyboard.press('Tab');
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, '#hover'), /^0\.7777467 s: impact/);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowLeft');
  assert.match(await text(page, '#hover'), /^0\.5569133 s: impact/);
  await page.keyboard.press('Enter');
  assert.match(await text(page, '#orbit-numbers'), /^at0\.5569133 s: impact/);
  assert.ok(await isShown(page, '#orbit'));
});

inPage('the legend hides impacts and curves', sticks, async (page) => {
  let last = await pixelsOf(page, '#chart canvas');
  for (const type of ['impact', 'stuck', 'energy']) {
    await page.click(`#legend button[data-type="${type}"]`);
    await settled(page);
    const now = await pixelsOf(page, '#chart canvas');
    assert.ok(now < last, `${type}: ${now} of ${last}`);
    last = now;
  }
});

inPage('the command makes the page again', sticks, async (page) => {
  const command = await text(page, '#orbit-command');
  const run = again(command);
  assert.equal(run.events.filter(({ kind }) => kind === 'impact').length, 82);
});

inPage('places with stops have a panel and a portrait each', supports, async (page) => {
  assert.match(await range(page), /^displacement towards stop 1 .*; displacement towards stop 2 .*; velocity towards stop 1 .*; contact force /);
  assert.ok(await isShown(page, '#orbit-place'));
  const first = await text(page, '#orbit-facts');
  await page.selectOption('#orbit-place select', '1');
  assert.notEqual(await text(page, '#orbit-facts'), first);
  const stops = await page.$$eval('#orbit-impacts tbody tr', (rows) => rows.map((row) => row.cells[1].textContent));
  assert.ok(stops.length > 0 && stops.every((stop) => stop === '2'), `${stops}`);
});

inPage('a stop far off the motion does not press it flat', far, async (page) => {
  assert.equal(await text(page, '#orbit-remark'), 'Beyond the picture lies stop 2, at −300 mm.');
});

inPage('a ball needs no forcing', ball, async (page) => {
  assert.match(await range(page), /over time from 0 s to 1 s/);
  await placeOf(page, '#chart canvas', { x: 0.3, y: 0.2 }, [60, 140]);
});

test('a motion in the dark and in the light differ', async () => {
  const dark = await openPage(browser, sticks(), { colorScheme: 'dark' });
  const before = await ground(dark.page);
  await placeOf(dark.page, '#chart canvas', { x: 0.5, y: 0.8 }, [225, 255]);  // the energy is white there
  await dark.page.click('#theme');
  assert.notEqual(await ground(dark.page), before);
  await placeOf(dark.page, '#chart canvas', { x: 0.5, y: 0.8 }, [0, 20]);
  assert.deepEqual(dark.wrong, []);
  await dark.close();
});
