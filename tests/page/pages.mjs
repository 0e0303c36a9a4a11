// What the tests of pages have in common: pages of commands, and what is asked of them in a browser.
//   node all.mjs PROGRAM SCENES CHROMIUM CHARTS [x_test.mjs ..]
import assert from 'node:assert/strict';
import { execFileSync, execSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';

export const [program, scenes, chromium, charts] = process.argv.slice(2);
export const folder = mkdtempSync(join(tmpdir(), 'graze page '));  // a blank, as in names of users
export const scene = (name) => join(scenes, name);
export let browser;

before(async () => { browser = await startBrowser(chromium); });

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

// What is made when it is first asked for, and once.
export function once(make) {
  let made;
  return () => (made ??= make());
}

const pages = new Map();  // by their names: the command, and what makes the page
function pageBy(name, ...command) {
  const words = JSON.stringify(command);
  const known = pages.get(name);
  if (known) assert.equal(known.words, words, `two pages are called ${name}`);
  else pages.set(name, { words, page: once(() => {
    execFileSync(...command, { stdio: ['ignore', 'ignore', 'inherit'] });
    return join(folder, name);
  }) });
  return pages.get(name).page;
}

// The page of a command; files of tests that ask for the same one share it.
export const pageOf = (name, ...arguments_) => pageBy(name, program, [...arguments_, '--quiet', '--plot', join(folder, name)]);

// The page of the chart of chart_page.cpp.
export const pageOfChart = (name) => pageBy(name, charts, [join(folder, name)]);

// What a command line that a page shows prints, as JSON; what it draws goes among the pages.
export function again(command) {
  assert.match(command, /^graze /);
  return JSON.parse(execSync(`"${program}"${command.slice('graze'.length)} --json --quiet`,
    { encoding: 'utf8', maxBuffer: 1 << 28, cwd: folder }));
}

export const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
export const range = (page) => page.getAttribute('#chart', 'aria-label');
export const isShown = (page, selector) => page.$eval(selector, (element) => !element.hidden);

// Opens the page, does what is to be done, and expects that nothing went wrong in the page.
export function inPage(name, file, act, options) {
  test(name, async () => {
    const opened = await openPage(browser, file(), options);
    try {
      await act(opened.page);
      await opened.check();
      assert.deepEqual(opened.wrong, []);
    } finally {
      await opened.close();
    }
  });
}

// The colour of a page's ground.
export const ground = (page) => page.$eval('body', (body) => getComputedStyle(body).backgroundColor);

export const packed = (kind, array) => ({ [kind]: Buffer.from(array.buffer).toString('base64') });

// What a button saves: its name and its bytes.
export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  const file = join(folder, `saved ${download.suggestedFilename()}`);
  await download.saveAs(file);
  return { name: download.suggestedFilename(), bytes: readFileSync(file) };
}

// The rows of a CSV file, each by the names of its columns.
export function rowsOf(csv) {
  const lines = csv.toString('utf8').replace(/^\ufeff/, '').trim().split('\n')
    .map((line) => [...`,${line}`.matchAll(/,(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, bare]) => quoted?.replaceAll('""', '"') ?? bare));
  const [head, ...rows] = lines;
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
}

// A table that the program wrote beside a page.
export const written = (...path) => rowsOf(readFileSync(join(folder, ...path)));

// Of an image that was saved: how wide and high, and its pixels as "#rrggbb".
export async function imageOf(page, bytes) {
  // As text: what a page returns is otherwise read number by number, seconds for an image.
  const { width, height, data } = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = `data:image/png;base64,${source}`;
    await image.decode();
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: image.width, height: image.height });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const pixels = new Blob([context.getImageData(0, 0, image.width, image.height).data]);
    const address = await new Promise((done) => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result);
      reader.readAsDataURL(pixels);
    });
    return { width: image.width, height: image.height, data: address.slice(address.indexOf(',') + 1) };
  }, bytes.toString('base64'));
  const pixels = Buffer.from(data, 'base64');
  const colour = (x, y) => pixels.readUIntBE(4 * (y * width + x), 3);
  const at = (x, y) => `#${colour(x, y).toString(16).padStart(6, '0')}`;
  // How many pixels of a colour lie between two heights.
  const count = (sought, top = 0, bottom = height) => {
    const number = Number.parseInt(sought.slice(1), 16);
    let found = 0;
    for (let y = top; y < bottom; ++y) for (let x = 0; x < width; ++x) if (colour(x, y) === number) ++found;
    return found;
  };
  return { width, height, at, count };
}
