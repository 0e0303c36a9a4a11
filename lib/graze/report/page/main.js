// A result of Graze as a page: a picture to look into, and what is behind its points.
import { ChartsView } from './charts_view.js';
import { Orbits, readView } from './data.js';
import { RunView } from './run_view.js';
import { fillTables } from './tables.js';
import { Theme } from './theme.js';

function fillHead(view) {
  const { graze, outcome, message } = view.head;
  document.title = `${view.title} · Graze`;
  document.getElementById('title').textContent = view.title;
  document.getElementById('subtitle').textContent = [graze.scene, view.subtitle].filter(Boolean).join(' · ');
  const told = document.getElementById('outcome');
  told.hidden = !message;
  told.textContent = message ? `${outcome}: ${message}` : '';
  document.getElementById('footer').textContent =
    `Graze ${graze.version} · drawn with Apache ECharts (Apache License 2.0), which is in this page; nothing is fetched.`;
}

// What opens a thing of the chart from the tables.
function startPicture(view, orbits, theme) {
  if (view.kind === 'run') return new RunView(view, theme);
  const chart = new ChartsView(view, orbits, theme);
  return (thing) => chart.openThing(thing);
}

function start() {
  const view = readView();
  const orbits = new Orbits();
  const theme = new Theme(document.getElementById('theme'));
  fillHead(view);
  fillTables(document.getElementById('tables'), view, startPicture(view, orbits, theme));
  document.documentElement.dataset.ready = 'true';
  requestAnimationFrame(() => requestAnimationFrame(() => performance.mark('drawn')));
}

start();
