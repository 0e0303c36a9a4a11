// A page in headless Chromium, cut off from any network, with a note of all that it did wrong.
import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';

export async function startBrowser(executablePath) {
  // As root, as in a container, Chromium runs without its sandbox or not at all.
  return chromium.launch({ executablePath, args: process.getuid?.() === 0 ? ['--no-sandbox'] : [] });
}

// Pages that are closed wait for the next file: a page that is opened anew takes three times as long.
const idle = [];
const kViewport = { width: 1360, height: 860 };

async function newPage(browser) {
  const context = await browser.newContext({ viewport: kViewport, offline: true });
  // What a page writes, in its text or on its canvases, is for people.
  await context.addInitScript(() => {
    window.words = new Set();
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function write(text, ...rest) {
      window.words.add(String(text));
      return fillText.call(this, text, ...rest);
    };
  });
  const open = { page: await context.newPage(), wrong: [], address: '' };
  open.page.on('console', (message) => {
    const mine = message.text().includes('willReadFrequently');  // the tests read what is drawn
    if (['error', 'warning'].includes(message.type()) && !mine) open.wrong.push(`${message.type()}: ${message.text()}`);
  });
  open.page.on('pageerror', (error) => open.wrong.push(`thrown: ${error.stack}`));
  open.page.on('request', (request) => { if (request.url() !== open.address) open.wrong.push(`asked for ${request.url()}`); });
  return open;
}

export async function openPage(browser, file, { colorScheme = 'light' } = {}) {
  const open = idle.pop() ?? await newPage(browser);
  const { page } = open;
  const wrong = open.wrong = [];
  open.address = pathToFileURL(file).href;
  await page.mouse.move(0, 0);
  await page.setViewportSize(kViewport);
  await page.emulateMedia({ colorScheme });
  await page.goto(open.address);
  await page.waitForSelector('html[data-ready]');
  await settled(page);
  const check = async () => {
    const words = await page.evaluate(() => [...window.words, document.body.innerText]);
    if (words.length < 3) wrong.push('written: nothing');
    for (const text of words) {
      const slip = /undefined|NaN|Infinity|\[object/.exec(text);
      if (slip) wrong.push(`written: ${text.slice(Math.max(0, slip.index - 60), slip.index + 60)}`);
    }
  };
  return { page, wrong, check, close: async () => { idle.push(open); } };
}

// Until what was asked for is drawn.
export async function settled(page) {
  await page.evaluate(() => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)));
  }));
}

// How many pixels of a canvas are not transparent.
export function pixelsOf(page, selector) {
  return page.$eval(selector, (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) ++count;
    return count;
  });
}

// Where a pixel of the given brightness (0 black, 255 white) is opaque on a canvas, on the screen;
// the one nearest to the part (x, y) of its size.
export async function placeOf(page, selector, { x, y }, [least, most]) {
  const place = await page.$eval(selector, (canvas, [px, py, low, high]) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext('2d').getImageData(0, 0, width, height);
    let best = null, nearest = Infinity;
    for (let i = 0; i < width * height; ++i) {
      const light = (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3;
      if (data[4 * i + 3] < 128 || light < low || light > high) continue;
      const distance = Math.hypot((i % width) / width - px, Math.floor(i / width) / height - py);
      if (distance < nearest) [nearest, best] = [distance, i];
    }
    if (best === null) return null;
    const box = canvas.getBoundingClientRect();
    return {
      x: box.x + ((best % width) + 0.5) * (box.width / width),
      y: box.y + (Math.floor(best / width) + 0.5) * (box.height / height),
    };
  }, [x, y, least, most]);
  if (!place) throw new Error(`nothing of that colour is drawn on ${selector}`);
  return place;
}
