// All tests of pages, or those of the files named, in one browser.
//   node all.mjs PROGRAM SCENES CHROMIUM CHARTS [x_test.mjs ..]
import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const named = process.argv.slice(6);
const files = named.length > 0 ? named : readdirSync(fileURLToPath(new URL('.', import.meta.url))).filter((name) => name.endsWith('_test.mjs')).sort();
for (const file of files) await import(`./${file}`);
