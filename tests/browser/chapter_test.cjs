// The reproduced chapter as a reader meets it, in a headless Chromium.
'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const {after, before, test} = require('node:test');
const browser = require('./browser.cjs');

const kPaperWidth = 695;  // of A4 without the margins of the style, in pixels of CSS
const kSections = [
  'differences', 'figure-1.1', 'figure-1.2', 'figure-1.3', 'figure-1.4', 'figure-1.5', 'figure-5.4',
  'section-6.1', 'table-8.1', 'figure-8.5', 'section-8.4', 'table-8.3', 'table-8.4', 'table-8.5',
  'table-8.6', 'table-8.7', 'table-8.8', 'figure-8.6', 'figure-8.7', 'figure-8.8', 'figure-8.9', 'drawings',
];

const originals = path.join(process.env.WELLSPACED_DATA ?? '', 'thesis');
const has_originals = process.env.WELLSPACED_DATA && fs.existsSync(path.join(originals, 'airfoil1.node'));

let page;

before(async () => {
  const data = has_originals ? ['--data', originals] : [];
  browser.run('reproduce', 'all', '--scale', '0.05', '--runs', '9', '--quiet', '-o', browser.folder, ...data);
  await browser.launch();
  page = await browser.openPage('index.html');
});

after(browser.close);

// The elements that are wider than what holds them.
const tooWide = () => page.evaluate(() => [document.documentElement, ...document.querySelectorAll('.table, figure')]
    .filter(box => box.scrollWidth > box.clientWidth + 1)
    .map(box => `${box.tagName} in ${box.closest('section')?.id}: ${box.scrollWidth} > ${box.clientWidth}`));

test('has every section, and a way to each', async () => {
  const ids = await page.locator('section').evaluateAll(all => all.map(section => section.id));
  assert.deepEqual(ids, kSections);
  const targets = await page.locator('nav a').evaluateAll(all => all.map(link => link.getAttribute('href')));
  assert.deepEqual(targets, kSections.map(id => '#' + id));
});

test('fits a screen of 1280 pixels', async () => {
  await page.setViewportSize({width: 1280, height: 900});
  assert.deepEqual(await tooWide(), []);
});

test('fits paper, tables and pictures whole', async () => {
  await page.emulateMedia({media: 'print'});
  await page.setViewportSize({width: kPaperWidth, height: 1000});
  assert.deepEqual(await tooWide(), []);
  const height = 1000;  // of a page, about
  const tall = await page.locator('figure').evaluateAll(
      (all, limit) => all.filter(figure => figure.clientHeight > limit).map(figure => figure.id), height);
  assert.deepEqual(tall, []);
  assert.ok((await page.pdf({format: 'A4'})).length > 100_000);
  await page.emulateMedia({media: 'screen'});
  await page.setViewportSize({width: 1280, height: 900});
});

test('draws every picture', async () => {
  const pictures = await page.locator('figure').evaluateAll(all => all.map(figure => ({
    id: figure.id, width: figure.querySelector('svg').clientWidth,
    marks: figure.querySelectorAll('svg path, svg circle').length,
    caption: figure.querySelector('figcaption').textContent})));
  assert.ok(pictures.length > 50, `${pictures.length} pictures`);
  for (const {id, width, marks, caption} of pictures)
    assert.ok(width > 250 && marks > 0 && caption, `${id}: ${width} wide, ${marks} marks`);
});

test('puts three lines beside each other: ours, the thesis, the difference', async () => {
  const whose = await page.locator('#table-8\\.6 tbody').nth(1).locator('td.whose').allTextContents();
  assert.deepEqual(whose, ['ours', 'thesis', 'difference']);
  const heads = await page.locator('#table-8\\.6 thead').first().locator('tr').last().locator('th').allTextContents();
  assert.deepEqual(heads, ['level', 'nodes', 'smallest', 'avg small.', 'smallest', 'avg small.', 'non-', 'boundary',
                           'avg mean', 'avg max']);
});

test('lists each figure with a star, and none else', async () => {
  const stars = await page.locator('td.beyond').count();
  const listed = await page.locator('table.reasons tr td:nth-child(2)').allTextContents();
  const places = listed.flatMap(text => text.split('; '));
  assert.equal(stars, places.length);
  if (has_originals) assert.ok(stars > 10, `${stars} figures differ`);
  const reasons = await page.locator('table.reasons tr td:nth-child(3)').allTextContents();
  for (const reason of reasons) assert.ok(reason.length > 5);
});

test('loads nothing and complains of nothing', browser.expectNoComplaint);
