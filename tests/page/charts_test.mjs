// The page of a chart made by hand (chart_page.cpp), in a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, settled } from './browser.mjs';
import { browser, ground, imageOf, inPage, isShown, pageOfChart, range, rowsOf, saved, text } from './pages.mjs';

const chart = pageOfChart('chart.html');

// The pixels about a place of the canvas, by their colours.
function colourCount(page, { x, y, width, height }, [red, green, blue]) {
  return page.$eval('#chart canvas', (canvas, [box, colour]) => {
    const scale = canvas.width / canvas.getBoundingClientRect().width;
    const { data } = canvas.getContext('2d').getImageData(...box.map((part) => Math.round(part * scale)));
    let count = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 60 && colour.every((part, k) => Math.abs(data[i + k] - part) < 12)) ++count;
    return count;
  }, [[x, y, width, height], [red, green, blue]]);
}

const kBlue = [0, 0x72, 0xb2], kVermillion = [0xd5, 0x5e, 0], kGreen = [0, 0x9e, 0x73], kStop = [0xdd, 0xdd, 0xdd];

async function size(page) { return (await page.$('#chart')).boundingBox(); }

// The upper panel: 92 px from the left, 20 from the right, 3.6 cm of 58 px high under 14 px; its axis goes
// from −2 % to 102 % of 9 ms, upright from 0 to 10.5 mm with 6 % more on both sides.
async function inUpper(page, time, displacement) {
  const { width } = await size(page);
  const part = (value, low, high, room) => (value - low + room * (high - low)) / ((1 + 2 * room) * (high - low));
  return { x: 92 + part(time, 0, 9, 0.02) * (width - 112), y: 14 + (1 - part(displacement, 0, 10.5, 0.06)) * 3.6 * 58 };
}

inPage('panels, legend and tables are there', chart, async (page) => {
  assert.equal(await text(page, 'h1'), 'All of a chart');
  assert.equal(await text(page, '#subtitle'), 'scene.toml · By hand');
  const titles = await page.$$eval('#legend button', (list) => list.map((button) => button.textContent));
  assert.deepEqual(titles, ['measured', 'fitted', 'behind the stop', 'bound']);
  assert.match(await range(page), /^displacement u from −0\.63 mm to 11\.13 mm over time from −0\.18 ms to 9\.18 ms; residual from/);
  assert.match(await range(page), /level from 0\.001 m to 1 m over frequency q₁ from 1 rad\/s to 3 rad\/s/);
  assert.match(await text(page, '#tables'), /Fitted parametersnamevalue \(m\)stop\.gap0\.001/);
});

inPage('the pointer is told a value with its error', chart, async (page) => {
  const box = await size(page);
  const { x, y } = await inUpper(page, 3, 4);
  await page.mouse.move(box.x + x, box.y + y);
  assert.equal(await text(page, '#hover'), 'measuredtime3 msdisplacement u4 mm ± 0.5 mm');
  const line = await inUpper(page, 6.9, 6.9);
  await page.mouse.move(box.x + line.x, box.y + line.y);
  assert.equal(await text(page, '#hover'), 'fittedtime7 msdisplacement u7 mm');
  const gap = await inUpper(page, 5, 4.9);  // where the line is broken
  await page.mouse.move(box.x + gap.x, box.y + gap.y);
  assert.ok(!await isShown(page, '#hover'));
});

inPage('bars of errors are as long as the errors', chart, async (page) => {
  const at = async (displacement) => {
    const { x, y } = await inUpper(page, 3, displacement);
    return colourCount(page, { x: x - 2, y: y - 1, width: 5, height: 2 }, kBlue);
  };
  assert.ok(await at(4.45) > 0 && await at(3.55) > 0);
  assert.equal(await at(4.65), 0);
  assert.equal(await at(3.35), 0);
});

inPage('the legend hides all of one title, in every panel', chart, async (page) => {
  const whole = { x: 0, y: 0, width: (await size(page)).width, height: (await size(page)).height };
  assert.ok(await colourCount(page, whole, kBlue) > 300);
  await page.click('#legend button[data-type="measured"]');
  await settled(page);
  assert.equal(await colourCount(page, whole, kBlue), 0);
  assert.ok(await colourCount(page, whole, kVermillion) > 100);
  const fill = { x: 300, y: 20, width: 50, height: 10 };
  assert.ok(await colourCount(page, fill, kStop) > 100);
  await page.click('#legend button[data-type="behind the stop"]');
  await settled(page);
  assert.equal(await colourCount(page, fill, kStop), 0);
});

inPage('logarithmic axes: a power is a straight line', chart, async (page) => {
  const { width, height } = await size(page);
  // Half the width is the third panel's; over 0 to 3 and −6 to 0, with 5 % more on both sides.
  const half = (width - 112 - 96) / 2, top = height - 50 - 2.6 * 58;
  const place = (steps, error) => ({ x: 92 + half * (steps / 3 + 0.05) / 1.1, y: top + 2.6 * 58 * (1 - (error / 6 + 1.05) / 1.1) });
  const box = await size(page);
  const { x, y } = place(1, -2);
  await page.mouse.move(box.x + x, box.y + y);
  assert.equal(await text(page, '#hover'), 'boundsteps10error0.01 s');
  let found = 0;
  for (let steps = 0.1; steps < 3; steps += 0.05) {
    const at = place(steps, -2 * steps);
    found += await colourCount(page, { x: at.x - 2, y: at.y - 2, width: 4, height: 4 }, kGreen) > 0;
  }
  assert.ok(found > 30, `${found} of 58, in dashes`);
});

inPage('panels over one axis are zoomed together, by a rectangle too', chart, async (page) => {
  const box = await size(page);
  const [from, to] = [await inUpper(page, 2, 8), await inUpper(page, 6, 2)];
  await page.click('#zoom-box');
  await page.mouse.move(box.x + from.x, box.y + from.y);
  await page.mouse.down();
  await page.mouse.move(box.x + to.x, box.y + to.y, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const told = await range(page);
  const [low, high] = told.match(/^displacement u from ([\d.]+) mm to ([\d.]+) mm over time from (?:2|1\.9)[\d.]* ms to (?:6|5\.9)[\d.]* ms; /).slice(1).map(Number);
  assert.ok(Math.abs(low - 2) < 0.1 && Math.abs(high - 8) < 0.1, told);
  assert.match(told, /residual from −1\.24 µm to 3\.24 µm over time from (?:2|1\.9)[\d.]* ms to (?:6|5\.9)/);
  assert.match(told, /over frequency q₁ from 1 rad\/s to 3 rad\/s/);
  await page.click('#zoom-reset');
  await settled(page);
  assert.match(await range(page), /over time from −0\.18 ms to 9\.18 ms/);
});

inPage('keys go from point to point', chart, async (page) => {
  await page.focus('#chart');
  await page.keyboard.press('ArrowRight');
  assert.equal(await text(page, '#hover'), 'measuredtime0 msdisplacement u1 mm ± 0.5 mm');
  await page.keyboard.press('ArrowRight');
  assert.equal(await text(page, '#hover'), 'measuredtime1 msdisplacement u2 mm ± 0.5 mm');
  await page.keyboard.press('ArrowDown');
  assert.equal(await text(page, '#hover'), 'fittedtime0 msdisplacement u0 mm');
  await page.keyboard.press('ArrowDown');
  assert.equal(await text(page, '#hover'), 'measuredtime0 msresidual1 µm ± 2 µm');
});

inPage('CSV and PNG have what is shown', chart, async (page) => {
  const rows = rowsOf((await saved(page, '#save-csv')).bytes);
  assert.deepEqual(Object.keys(rows[0]), ['series', 'time (ms)', 'displacement u (mm)', 'residual (µm)', 'steps', 'error (s)',
    'frequency q₁ (rad/s)', 'level (dB re 1 m)', '± displacement u (mm)', '± residual (µm)']);
  const measured = rows.filter((row) => row.series === 'measured' && row['displacement u (mm)'] !== '');
  assert.deepEqual(measured.map((row) => Number(row['displacement u (mm)'])), [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  assert.ok(measured.every((row) => row['± displacement u (mm)'] === '0.5'));
  assert.deepEqual(rows.filter(({ series }) => series === 'bound').map((row) => row['error (s)']), ['1', '0.01', '0.0001', '0.000001']);
  await page.click('#legend button[data-type="measured"]');
  await settled(page);
  assert.ok(rowsOf((await saved(page, '#save-csv')).bytes).every(({ series }) => series !== 'measured'));
  const image = await imageOf(page, (await saved(page, '#save-png')).bytes);
  assert.ok(image.count('#d55e00', 56, image.height - 40) > 100 && image.count('#d55e00', image.height - 40) > 10);
  assert.equal(image.count('#0072b2'), 0);
});

test('a chart in the dark and in the light differ', async () => {
  const dark = await openPage(browser, chart(), { colorScheme: 'dark' });
  const before = await ground(dark.page);
  await dark.page.click('#theme');
  assert.notEqual(await ground(dark.page), before);
  assert.deepEqual(dark.wrong, []);
  await dark.close();
});
