// What the tests of pages have in common: pages of commands, and what is asked of them in a browser.
//   node x_test.mjs PROGRAM SCENES CHROMIUM
import assert from 'node:assert/strict';
import { execFileSync, execSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';

const [program, scenes, chromium] = process.argv.slice(2);
export const folder = mkdtempSync(join(tmpdir(), 'graze page '));  // a blank, as in names of users
export const scene = (name) => join(scenes, name);
export let browser;

before(async () => { browser = await startBrowser(chromium); });

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

// The page of a command.
export function pageOf(name, ...arguments_) {
  const file = join(folder, name);
  execFileSync(program, [...arguments_, '--quiet', '--plot', file], { stdio: ['ignore', 'ignore', 'inherit'] });
  return file;
}

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
      assert.deepEqual(opened.wrong, []);
    } finally {
      await opened.close();
    }
  });
}

// The colour of a page's ground.
export const ground = (page) => page.$eval('body', (body) => getComputedStyle(body).backgroundColor);

export const packed = (kind, array) => ({ [kind]: Buffer.from(array.buffer).toString('base64') });
