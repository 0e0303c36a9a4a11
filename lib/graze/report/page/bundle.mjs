// Puts the page together: node bundle.mjs FOLDER FILE
//
// Bundles main.js with the parts of ECharts that it uses (from node_modules beside this file) into
// one script, puts it and the style into index.html, with the licences of what is in it, and writes
// that as a C++ file, in string literals short enough for every compiler.
import { readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const kPiece = 12000;  // characters

const here = dirname(fileURLToPath(import.meta.url));
const text = (...path) => readFile(join(here, ...path), 'utf8');

async function bundled(options) {
  const result = await build({
    absWorkingDir: here, bundle: true, minify: true, write: false, charset: 'utf8',
    legalComments: 'none', target: 'es2022', logLevel: 'warning', ...options,
  });
  return result.outputFiles[0].text.trim();
}

// Apache ECharts draws with ZRender, both are compiled with tslib; all their licences ask to be kept.
async function licences() {
  const parts = [];
  for (const name of ['echarts', 'zrender', 'tslib']) {
    const { version, license } = JSON.parse(await text('node_modules', name, 'package.json'));
    parts.push(`This page contains ${name} ${version} (${license}).`);
    if (name === 'echarts') parts.push(await text('node_modules', name, 'NOTICE'));
    parts.push(await text('node_modules', name, name === 'tslib' ? 'LICENSE.txt' : 'LICENSE'));
  }
  return parts.join('\n\n').replaceAll('--', '- -');
}

function literal(page) {
  const pieces = [];
  for (let at = 0; at < page.length; ) {
    let end = Math.min(at + kPiece, page.length);
    const code = page.charCodeAt(end - 1);
    if (code >= 0xd800 && code < 0xdc00) --end;  // no character is cut in two
    pieces.push(`R"page(${page.slice(at, end)})page"`);
    at = end;
  }
  return `// Made by bundle.mjs.\n#include "graze/report/page/detail/page_template.hpp"\n\nnamespace graze {\n` +
    `std::string_view page_template() {\n  static constexpr char kPage[] =\n${pieces.join('\n')};\n` +
    '  return {kPage, sizeof(kPage) - 1};\n}\n}  // namespace graze\n';
}

const [script, style, page, notes] = await Promise.all([
  bundled({ entryPoints: ['main.js'], format: 'iife' }),
  bundled({ entryPoints: ['page.css'] }), text('index.html'), licences(),
]);
const whole = page.replace('<!doctype html>', () => `<!doctype html>\n<!--\n${notes}\n-->`)
  .replace('/*style*/', () => style)
  .replace('/*script*/', () => script.replaceAll('</script', '<\\/script'));
await writeFile(process.argv[2], literal(whole));
