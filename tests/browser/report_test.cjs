// The coarsening report as a reader meets it, in a headless Chromium.
'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const {after, before, beforeEach, afterEach, test} = require('node:test');
const browser = require('./browser.cjs');

const {file, run} = browser;
const kPanels = '.panels canvas';

let page, runs;

before(async () => {
  run('generate', 'airfoil', '--nodes', '16000', '-o', file('wing'));
  runs = JSON.parse(run('coarsen', file('wing'), '--method', 'function,mis', '--stats', 'full',
                        '--report', file('both.html'), '--json', '-')).runs;
  run('coarsen', file('wing'), '--report', file('one.html'));
  run('generate', 'grid', '--nx', '30', '--ny', '20', '-o', file('grid'));
  run('coarsen', file('grid'), '--method', 'function,mis', '--stats', 'none', '--report', file('grid.html'));
  await browser.launch();
});

after(browser.close);

beforeEach(async () => { await open('both.html'); });
afterEach(async () => {
  await page.close();
  browser.expectNoComplaint();
});

async function open(name, options) {
  await page?.close();
  page = await browser.openPage(name, options);
}

const drawn = () => browser.drawn(page);

const captions = () => page.locator('.panels figcaption p').allTextContents();
const pictures = () => page.locator(kPanels).evaluateAll(all => all.map(canvas => canvas.toDataURL()));

// For each canvas the share of pixels that differ from the most frequent colour.
const shareDrawn = () => page.locator(kPanels).evaluateAll(all => all.map(canvas => {
  const pixels = new Uint32Array(
      canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer);
  const counts = new Map();
  for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
  return 1 - Math.max(...counts.values()) / pixels.length;
}));

const colour = (selector, property) => page.locator(selector).first().evaluate(
    (node, name) => getComputedStyle(node)[name].match(/[\d.]+/g).slice(0, 3).map(Number), property);

// The contrast of WCAG 2: 1 to 21.
function contrast(one, other) {
  const luminance = rgb => rgb.map(v => v / 255)
      .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
      .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const [dark, light] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (light + 0.05) / (dark + 0.05);
}

test('draws both methods', async () => {
  const shares = await shareDrawn();
  assert.equal(shares.length, 2);
  for (const share of shares) assert.ok(share > 0.05 && share < 0.95, `${share} of a picture is drawn`);
  assert.ok((await page.screenshot()).length > 50_000, 'the screenshot is not blank');
});

// A function that tells whether one of the points is within 1e-8 of (x, y).
function nearness(points) {
  const cell = v => Math.round(v * 1e6);
  const cells = new Map();
  for (const [x, y] of points) cells.set(`${cell(x)} ${cell(y)}`, [x, y]);
  return ([x, y]) => [-1, 0, 1].some(i => [-1, 0, 1].some(j => {
    const found = cells.get(`${cell(x) + i} ${cell(y) + j}`);
    return found && Math.hypot(found[0] - x, found[1] - y) < 1e-8;
  }));
}

test('decodes the mesh that was coarsened', async () => {
  const rows = fs.readFileSync(file('wing.node'), 'utf8').split('\n')
      .map(row => row.trim().split(/\s+/).map(Number));
  const expected = rows.slice(1, 1 + rows[0][0]).map(([, x, y]) => [x, y]);
  const {points, counts} = await page.evaluate(() => {
    const report = decodeReport(JSON.parse(document.getElementById('data').textContent));
    return {
      points: Array.from(report.points.x, (x, i) => [x, report.points.y[i]]),
      counts: report.methods.map(method => method.levels.map(({geometry: g}) => [
        g.nodes.length, g.triangles.length / 3, g.segments.length / 2, Math.min(...g.angles)])),
    };
  });
  assert.equal(points.length, expected.length);
  assert.ok(expected.every(nearness(points)), 'every node is there, to 2^-32 of the domain');
  runs.forEach((run, k) => run.levels.forEach((level, l) => {
    const [nodes, triangles, segments, angle] = counts[k][l];
    assert.deepEqual([nodes, triangles, segments], [level.nodes, level.triangles, level.boundary_edges]);
    const smallest = Math.min(level.angles.interior_min ?? 180, level.angles.boundary_min ?? 180);
    assert.ok(Math.abs(angle - smallest) < 0.01, `${angle} for ${smallest} degrees`);
  }));
});

test('the slider changes the level, by mouse and by keyboard', async () => {
  const [text, image] = [await captions(), await pictures()];
  await page.focus('#level');
  await page.keyboard.press('ArrowRight');
  await drawn();
  assert.notDeepEqual(await captions(), text);
  assert.notDeepEqual(await pictures(), image);
  await page.keyboard.press('Home');
  assert.match((await captions())[0], /^level 0 · /);
  await page.locator('#level').fill('1');
  assert.match((await captions())[1], /^level 1 · /);
});

test('compares levels of equal size, or of equal number', async () => {
  const last = await page.locator('#level').getAttribute('max');
  await page.locator('#level').fill(String(last - 1));
  const levels = async () => (await captions()).map(text => Number(text.match(/level (\d+)/)[1]));
  await page.locator('#match').uncheck();
  assert.deepEqual(new Set(await levels()).size, 1);
  await page.locator('#match').check();
  const [a, b] = await levels();
  const leader = runs[0].levels.length >= runs[1].levels.length ? 0 : 1;
  const size = runs[leader].levels[leader ? b : a].nodes;
  const distances = runs[1 - leader].levels.map(level => Math.abs(Math.log(level.nodes / size)));
  assert.equal(leader ? a : b, distances.indexOf(Math.min(...distances)));
});

test('zooms and moves by keys, buttons, wheel and pointer, both pictures together', async () => {
  const start = await pictures();
  const expectChange = async action => {
    const old = await pictures();
    await action();
    await drawn();
    (await pictures()).forEach((image, k) => assert.notEqual(image, old[k]));
  };
  const canvas = page.locator(kPanels).first();
  await canvas.focus();
  for (const key of ['+', 'ArrowLeft', 'ArrowUp', '-', '0'])
    await expectChange(() => page.keyboard.press(key));
  for (const id of ['#view-dense', '#zoom-in', '#zoom-out', '#view-finest', '#view-whole'])
    await expectChange(() => page.click(id));
  await canvas.click();
  await expectChange(() => page.mouse.wheel(0, -300));
  await expectChange(async () => {
    await page.mouse.down();
    await page.mouse.move(300, 500);
    await page.mouse.up();
  });
  await page.click('#view-dense');
  await drawn();
  assert.deepEqual(await pictures(), start, 'the dense part is what the page opens with');
});

test('the wheel scrolls the page until a picture is clicked', async () => {
  const old = await pictures();
  await page.locator(kPanels).first().hover();
  await page.mouse.wheel(0, 200);
  await drawn();
  assert.deepEqual(await pictures(), old);
});

test('shows which nodes go', async () => {
  await page.click('#show-why');
  await drawn();
  assert.ok(await page.locator('#kept').isChecked());
  assert.match((await captions())[0], /^level 0 · /);
  const marked = await pictures();
  await page.locator('#kept').uncheck();
  await drawn();
  assert.notDeepEqual(await pictures(), marked);
});

test('says in words and figures what the data say', async () => {
  const lead = await page.locator('#lead').textContent();
  assert.ok(lead.includes(runs[0].levels[0].nodes.toLocaleString('en-US')));
  assert.match(lead, /evens the mesh out\. Independent sets \(MIS\) keep its grading/);
  const cards = await page.locator('.card').all();
  assert.equal(cards.length, 2);
  for (const [k, card] of cards.entries()) {
    const number = Number((await card.textContent()).match(/nodes at level (\d+)/)[1]);
    const {nodes} = runs[k].levels[number];
    const smallest = Math.min(...runs[k].levels.slice(1).filter(level => level.nodes >= 50)
        .map(({angles}) => angles.interior_min ?? 180));
    const figures = await card.locator('.figures strong').allTextContents();
    assert.equal(figures[0], nodes.toLocaleString('en-US'));
    assert.equal(figures[2], smallest.toFixed(1) + '°');
  }
});

test('tables have a row for each level, with the figures of the JSON', async () => {
  for (const [k, {levels}] of runs.entries()) {
    const rows = page.locator('table').nth(k).locator('tbody tr');
    assert.equal(await rows.count(), levels.length);
    for (const [l, level] of levels.entries()) {
      const cells = await rows.nth(l).locator('th, td').allTextContents();
      assert.deepEqual(cells.slice(0, 4), [l, level.nodes, level.triangles, level.boundary_edges]
          .map(value => value.toLocaleString('en-US')));
      if (level.intersection) assert.ok(cells.includes(level.intersection.mean.toFixed(2)));
    }
  }
  const notes = await page.locator('#tables .legend').textContent();
  for (const name of ['Gradation', 'Intersection', 'Path depth', 'Node search', 'Edge search'])
    assert.ok(notes.includes(name + ': '), `${name} is explained`);
});

test('charts draw a mark for each measured value', async () => {
  const marks = await page.locator('#charts figure > div svg').evaluateAll(
      charts => charts.map(svg => svg.querySelectorAll('g').length));
  const levels = runs.reduce((sum, run) => sum + run.levels.length, 0);
  const angles = runs.flatMap(run => run.levels).flatMap(({angles: a}) => [a.interior_min, a.boundary_min]);
  assert.deepEqual(marks, [20, angles.filter(angle => angle !== null).length, levels]);
});

test('saves every picture and chart as SVG', async () => {
  const buttons = page.getByRole('button', {name: 'Save as SVG'});
  assert.equal(await buttons.count(), 5);
  for (let i = 0; i < 5; ++i) {
    const [download] = await Promise.all([page.waitForEvent('download'), buttons.nth(i).click()]);
    assert.match(download.suggestedFilename(), /^[a-z_0-9]+\.svg$/);
    const svg = fs.readFileSync(await download.path(), 'utf8');
    assert.match(svg, /^<svg xmlns=[^]*<\/svg>\s*$/);
    assert.doesNotMatch(svg, /var\(|NaN|undefined/);
    assert.equal(await page.evaluate(text => new DOMParser().parseFromString(text, 'image/svg+xml')
        .querySelectorAll('parsererror').length, svg), 0);
  }
});

for (const colorScheme of ['light', 'dark'])
  test(`can be read in ${colorScheme} colours`, async () => {
    await open('both.html', {colorScheme});
    const page_colour = await colour('body', 'backgroundColor'), panel = await colour('figure', 'backgroundColor');
    assert.equal(page_colour[0] < 128, colorScheme === 'dark');
    assert.ok(contrast(await colour('body', 'color'), page_colour) > 10);
    for (const selector of ['figcaption p', '.figures', 'button'])
      assert.ok(contrast(await colour(selector, 'color'), panel) > 4.5, selector);
    assert.ok(contrast(await colour('.legend', 'color'), page_colour) > 4.5);
    for (const share of await shareDrawn()) assert.ok(share > 0.05);
  });

test('pictures follow a change of colours', async () => {
  const light = await pictures();
  await page.emulateMedia({colorScheme: 'dark'});
  await drawn();
  assert.notDeepEqual(await pictures(), light);
});

test('prints on white paper without controls', async () => {
  await open('both.html', {colorScheme: 'dark'});
  assert.ok((await page.pdf({format: 'A4'})).length > 50_000);
  await drawn();
  await page.emulateMedia({media: 'print'});
  for (const id of ['#level', '#view-whole', '#show-why']) assert.ok(!await page.locator(id).isVisible());
  for (const heading of await page.locator('h2').all()) assert.ok(await heading.isVisible());
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  assert.ok((await colour('body', 'backgroundColor'))[0] > 240);
});

for (const width of [1280, 800, 400])
  test(`fits ${width} pixels`, async () => {
    await page.setViewportSize({width, height: 900});
    await drawn();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width);
    for (const share of await shareDrawn()) assert.ok(share > 0.05);
  });

test('can be used by keyboard alone', async () => {
  const reached = new Set();
  for (let i = 0; i < 30; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.tagName));
  }
  for (const id of ['level', 'match', 'kept', 'zoom-in', 'view-finest', 'show-why', 'CANVAS', 'BUTTON'])
    assert.ok(reached.has(id), `${id} is reached by Tab`);
  const labels = await page.locator(kPanels).evaluateAll(all => all.map(canvas => canvas.getAttribute('aria-label')));
  labels.forEach((label, k) => assert.match(label, k ? /MIS-based, level/ : /Function-based, level/));
});

test('one method makes a report, too', async () => {
  await open('one.html');
  assert.equal((await shareDrawn()).length, 1);
  assert.ok(!await page.locator('#match').isVisible());
  assert.match(await page.locator('#lead .headline').textContent(), /Function-based coarsening of/);
});

test('a uniform mesh without measured angles makes a report, too', async () => {
  await open('grid.html');
  for (const share of await shareDrawn()) assert.ok(share > 0.02);
  assert.match(await page.locator('#lead').textContent(), /600 nodes .* nearly uniform in size/);
  assert.deepEqual(await page.locator('table').first().locator('thead tr').last().locator('th').allTextContents(),
                   ['level', 'nodes', 'triangles', 'boundary edges']);
  assert.equal(await page.locator('#tables .legend').count(), 0, 'no column needs a word');
});
