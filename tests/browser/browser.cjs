// What the tests of the pages share: a folder, a headless Chromium, and pages that must not complain.
'use strict';

const assert = require('node:assert/strict');
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {chromium} = require('playwright-core');

const kChromium = process.env.CHROMIUM ?? '/usr/bin/chromium';
const kArguments = [
  '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'wellspaced-browser-'));
const file = name => path.join(folder, name);
const run = (...words) => execFileSync(process.env.WELLSPACED_PROGRAM, words, {encoding: 'utf8'});

let browser, complaints = [];

async function launch() {
  browser = await chromium.launch({executablePath: kChromium, args: kArguments});
}

async function close() {
  await browser?.close();
  fs.rmSync(folder, {recursive: true});
}

// A page that shows a file of the folder.
async function openPage(name, options = {}) {
  complaints = [];
  const page = await browser.newPage({viewport: {width: 1280, height: 900}, ...options});
  page.on('console', message => complaints.push(message.text()));
  page.on('pageerror', error => complaints.push(error.message));
  page.on('request', request => {
    if (!/^(file|blob|data):/.test(request.url())) complaints.push(request.url());
  });
  await page.goto('file://' + file(name));
  await drawn(page);
  return page;
}

// Waits until the frame that was asked for has been drawn.
const drawn = page => page.evaluate(() => new Promise(
    done => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)))));

function expectNoComplaint() {
  assert.deepEqual(complaints, [], 'on the console, or requests to elsewhere');
}

module.exports = {close, drawn, expectNoComplaint, file, folder, launch, openPage, run};
