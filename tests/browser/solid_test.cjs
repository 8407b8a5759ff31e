// The report of a mesh in space as a reader meets it, in a headless Chromium.
'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const {after, before, beforeEach, afterEach, test} = require('node:test');
const browser = require('./browser.cjs');

const {file, run} = browser;
// A box of 2 x 1 x 1.
const kBox = `8 3 0 0
1 0 0 0\n2 2 0 0\n3 0 1 0\n4 2 1 0\n5 0 0 1\n6 2 0 1\n7 0 1 1\n8 2 1 1
6 0\n4 1 2 4 3\n4 5 6 8 7\n4 1 2 6 5\n4 3 4 8 7\n4 1 3 7 5\n4 2 4 8 6\n0\n0\n`;

let page, counts;

before(async () => {
  fs.writeFileSync(file('box.smesh'), kBox);
  counts = JSON.parse(run('mesh', file('box.smesh'), '--report', file('box.html'), '--json', '-'));
  run('mesh', file('box.smesh'), '--beta', '36', '--report', file('fine.html'));
  await browser.launch();
});

after(browser.close);

beforeEach(async () => { await open(); });
afterEach(async () => {
  await page.close();
  browser.expectNoComplaint();
});

async function open(name = 'box.html') {
  await page?.close();
  page = await browser.openPage(name);
}

const drawn = () => browser.drawn(page);
const picture = () => page.locator('#solid').evaluate(canvas => canvas.toDataURL());
const facesShown = async () =>
    (await page.textContent('#shown')).match(/\d[\d,]*/g).map(text => Number(text.replace(',', '')));

async function expectChange(action) {
  const old = await picture();
  await action();
  await drawn();
  assert.notEqual(await picture(), old);
}

test('decodes the mesh: its tets fill the box, and its boundary is the one of the files', async () => {
  const {tets, volume} = await page.evaluate(() => {
    const solid = new Solid(JSON.parse(document.getElementById('data').textContent));
    let volume = 0;
    for (let t = 0; t < solid.count; ++t) {
      const [a, b, c, d] = solid.corners(t);
      volume += dot(minus(b, a), cross(minus(c, a), minus(d, a))) / 6;
    }
    return {tets: solid.count, volume};
  });
  assert.equal(tets, counts.tets);
  assert.ok(Math.abs(volume - 2) < 1e-6, `${volume}: a box with the longest side 2`);
  await page.locator('#cut').fill('0');
  assert.deepEqual(await facesShown(), [counts.boundary_faces, 0]);
});

test('the slider cuts, by keyboard, along each axis', async () => {
  const [outside, inside] = await facesShown();
  assert.ok(outside > 0 && outside < counts.boundary_faces && inside > 0);
  await page.focus('#cut');
  await expectChange(() => page.keyboard.press('ArrowRight'));
  assert.equal(await page.textContent('#cut-text'), '51 %');
  for (const axis of ['1', '2', '3', '4', '5'])
    await expectChange(() => page.selectOption('#axis', axis));
  await page.locator('#cut').fill('100');
  assert.deepEqual(await facesShown(), [0, 0]);
});

test('keys, buttons, pointer and wheel turn and zoom it, and it comes back', async () => {
  const start = await picture();
  await page.focus('#solid');
  for (const key of ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', '+', '-', '='])
    await expectChange(() => page.keyboard.press(key));
  await expectChange(() => page.keyboard.press('0'));
  assert.equal(await picture(), start);
  for (const id of ['#turn-left', '#turn-up', '#zoom-in', '#view-reset'])
    await expectChange(() => page.click(id));
  await page.locator('#solid').click();
  await expectChange(() => page.mouse.wheel(0, -300));
  await expectChange(async () => {
    await page.mouse.down();
    await page.mouse.move(500, 600);
    await page.mouse.up();
  });
  await page.click('#view-reset');
  await drawn();
  assert.equal(await picture(), start);
});

test('hides edges, marks flat tets, and follows the colour scheme', async () => {
  await expectChange(() => page.uncheck('#edges'));
  await page.check('#edges');
  await drawn();
  const light = await picture();
  await page.check('#flat');
  await drawn();
  await page.uncheck('#flat');
  await expectChange(() => page.emulateMedia({colorScheme: 'dark'}));
  assert.notEqual(await picture(), light);
});

test('every control has a name, and can be reached by the keyboard', async () => {
  const reached = new Set();
  for (let k = 0; k < 20; ++k) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.id));
  }
  for (const id of ['cut', 'axis', 'edges', 'flat', 'turn-left', 'zoom-out', 'view-reset', 'save', 'solid'])
    assert.ok(reached.has(id), id);
  assert.match(await page.getAttribute('#solid', 'aria-label'), /Arrow keys turn/);
});

test('saves the picture as SVG', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
  const svg = fs.readFileSync(await download.path(), 'utf8');
  assert.match(svg, /^<svg /);
  assert.ok(svg.match(/<path/g).length > 100);
});

test('says so where a mesh is too large to be drawn', async () => {
  await open('fine.html');
  assert.match(await page.getAttribute('#solid', 'aria-label'), /tets: too many to draw here/);
  assert.equal(await page.textContent('#legend'), '');
});
