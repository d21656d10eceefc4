// What tests of pages have in common: a browser without a screen, which is /usr/bin/chromium or what the environment
// variable CHROMIUM names, and what no page may do.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
export const largeWindow = {
  width: 1440,
  height: 900
};

/** What an element of a page's file holds, as it stands there: null if there is none. */
export function blockOf(html, id) {
  const start = html.indexOf(`id="${id}">`);
  if (start < 0) return null;
  const from = start + `id="${id}">`.length;
  return html.subarray(from, html.indexOf('</script>', from)).toString('latin1');
}

export const text = (page, selector) => page.locator(selector).innerText();
export const press = async (page, ...keys) => {
  for (const key of keys) await page.keyboard.press(key);
};

/** Two frames: whatever was asked to be drawn is drawn. */
export const drawn = (page) =>
    page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

export async function assertFitsEveryWindow(page) {
  for (const width of [320, 375, 768, 1280, 1920]) {
    await page.setViewportSize({width, height: 900});
    await drawn(page);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert(wide <= 0, `${width}: ${wide} too wide`);
  }
}

export async function assertNoAxeViolations(page, what) {
  await page.evaluate(axeSource);
  const violations = await page.evaluate(
      async () =>
          (await window.axe.run(document))
              .violations.map(
                  ({id, help, nodes}) => `${id}: ${help}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`));
  assert.deepEqual(violations, [], what);
}

/** Opens a file, and lists the requests, errors, messages and dialogs that it makes from then on. */
export async function openPage(browser, path) {
  const url = pathToFileURL(resolve(path)).href;
  const page = await browser.newPage({viewport: largeWindow, hasTouch: true, colorScheme: 'light'});
  page.setDefaultTimeout(20000);
  const unwanted = [];
  page.on('request', (request) => {
    if (request.url() !== url) unwanted.push(`request: ${request.url()}`);
  });
  page.on('pageerror', (error) => unwanted.push(`error: ${error.stack}`));
  page.on('console', (message) => unwanted.push(`console: ${message.text()}`));
  page.on('dialog', (dialog) => {
    unwanted.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  await page.goto(url, {timeout: 60000});
  return {page, unwanted};
}

const results = {
  passed: 0,
  failed: 0
};

async function run(name, test) {
  try {
    await test();
    ++results.passed;
  } catch (error) {
    ++results.failed;
    console.log(`FAILED: ${name}\n${error.stack}\n`);
  }
}

async function testPage(browser, path, {readPage, reset, tests}) {
  const data = readPage(path);
  const {page, unwanted} = await openPage(browser, path);
  for (const [name, test] of Object.entries(tests)) {
    await run(`${path}: ${name}`, async () => {
      await reset(page);
      await test(page, data, browser);
    });
  }
  await run(`${path}: no request, error or message`, async () => assert.deepEqual(unwanted, []));
  await page.close();
}

/** Runs the tests, by their names, on the pages that the command names. Each starts with `reset(page)`. */
export async function testPages(given) {
  const [, script, ...paths] = process.argv;
  if (paths.length === 0) {
    console.error(`usage: node ${script} PAGE.html...`);
    process.exit(2);
  }
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync'
    ],
  });
  for (const path of paths) await testPage(browser, path, given);
  await browser.close();
  console.log(`${results.passed} passed, ${results.failed} failed`);
  process.exitCode = results.failed === 0 ? 0 : 1;
}
