// Drives the page that grading writes of a class, in a browser without a screen: node class_page_test.mjs INDEX.html...
// raylab-sample-reports writes one, with hostile text in it.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {assertFitsEveryWindow, assertNoAxeViolations, blockOf, largeWindow, press, testPages, text} from './browser.mjs';

const readPage = (path) => JSON.parse(blockOf(readFileSync(path), 'report'));

async function reset(page) {
  await page.emulateMedia({colorScheme: 'light', media: 'screen'});
  await page.setViewportSize(largeWindow);
  await page.reload();
}

const textsOf = (page, selector) => page.locator(selector).evaluateAll((all) => all.map((element) => element.textContent));
const headerOf = (page, title) => page.locator('th', {has: page.getByRole('button', {name: title, exact: true})});

/** A column of the table, from the first line to the last. */
async function columnOf(page, title) {
  const titles = await page.locator('th button').evaluateAll((all) => all.map((button) => button.ariaLabel ?? button.textContent));
  return textsOf(page, `#rows td:nth-child(${titles.indexOf(title) + 1})`);
}

const numbers = (cells) => cells.map((cell) => (cell === '–' ? -1 : Number(cell)));
const isFalling = (values) => values.every((value, k) => k === 0 || value <= values[k - 1]);

const tests = {
  async 'what raylab failed to judge stands on top'(page, {submissions, unsafe}) {
    const failed = submissions.filter(({unjudged}) => unjudged.length > 0);
    const alerts = await textsOf(page, '.alert');
    assert.equal(alerts.length, (failed.length > 0) + unsafe);
    for (const {unjudged} of failed) assert(alerts.at(-1).includes(unjudged[0]));
  },

  async 'the histogram counts every submission once'(page, {submissions}) {
    const counts = (await textsOf(page, '.histogram .over')).map(Number);
    assert.equal(counts.reduce((all, count) => all + count, 0), submissions.length);
    assert.equal(await page.locator('.histogram rect').count(), counts.length);
  },

  async 'tasks are shown with the most missed first, and their verdicts'(page, {tasks, submissions}) {
    const lines = await textsOf(page, '#tasks li');
    assert.equal(lines.length, tasks.length);
    assert(isFalling(tasks.map(({missed}) => missed)));
    for (const [k, {label, verdicts}] of tasks.entries()) {
      assert(lines[k].startsWith(label));
      for (const {verdict, count} of verdicts) assert(lines[k].includes(`${count} ${verdict.replaceAll('_', ' ')}`));
      assert.equal(verdicts.reduce((all, {count}) => all + count, 0), submissions.length);
    }
  },

  async 'what does not hold of the sandbox is red'(page, {guarantees}) {
    assert.equal(await page.locator('.guarantee').count(), guarantees.length);
    assert.equal(await page.locator('.guarantee.lacks').count(), guarantees.filter(({holds}) => !holds).length);
    if (guarantees.length === 0) return assert.equal(await text(page, '#guarantees'), 'There was none.');
    const color = await page.locator('.guarantee.lacks b').first().evaluate((element) => getComputedStyle(element).color);
    const bad = await page.evaluate(() => {
      document.body.style.outlineColor = 'var(--bad)';
      return getComputedStyle(document.body).outlineColor;
    });
    assert.equal(color, bad);
  },

  async 'a class that was graded without a sandbox says so before all else'(page, {unsafe}) {
    assert.equal(await page.locator('.alert.grave').count(), unsafe ? 1 : 0);
    if (unsafe) assert((await textsOf(page, '.alert'))[0].startsWith('Graded without a sandbox'));
  },

  async 'each submission has a line, and a link to its page'(page, {submissions}) {
    const links = await page.locator('#rows a').evaluateAll((all) => all.map((link) => link.getAttribute('href')));
    assert.deepEqual(links.toSorted(), submissions.map(({id}) => `submissions/${encodeURIComponent(id)}/report.html`).toSorted());
    assert.deepEqual((await columnOf(page, 'Id')).toSorted(), submissions.map(({id}) => id).toSorted());
    for (const file of ['results.json', 'gradebook.csv']) assert(await page.isVisible(`a[href="${file}"]`));
  },

  async 'numbers sort with the greatest first, and back'(page) {
    for (const title of ['Points', 'Seconds', 'Stage 5']) {
      await page.getByRole('button', {name: title, exact: true}).click();
      assert.equal(await headerOf(page, title).getAttribute('aria-sort'), 'descending');
      assert(isFalling(numbers(await columnOf(page, title))), title);
      await page.getByRole('button', {name: title, exact: true}).click();
      assert.equal(await headerOf(page, title).getAttribute('aria-sort'), 'ascending');
      assert(isFalling(numbers(await columnOf(page, title)).reverse()), title);
    }
    assert.equal(await page.locator('th[aria-sort]').count(), 1);
  },

  async 'names sort from A to Z, verdicts by how grave they are, by keyboard too'(page, {verdicts}) {
    await page.getByRole('button', {name: 'Worst verdict'}).focus();
    await press(page, 'Enter');
    const grave = (await columnOf(page, 'Worst verdict')).map((words) => verdicts.indexOf(words.replaceAll(' ', '_')));
    assert(isFalling(grave.toReversed()) && !grave.includes(-1));
    await page.getByRole('button', {name: 'Name'}).focus();
    await press(page, 'Space');
    assert.equal(await headerOf(page, 'Name').getAttribute('aria-sort'), 'ascending');
    const names = await columnOf(page, 'Name');
    assert(names.indexOf('Ada Lovelace') < names.findIndex((name) => name.startsWith('Zo')));
  },

  async 'hostile text is text'(page) {
    assert.equal(await page.title(), 'raylab: results of the class');
    assert.equal(await page.locator('script').count(), 2);
    assert.equal(await page.locator('img').count(), 0);
    assert((await text(page, '#rows')).includes('</script><script>'));
  },

  async 'the slowest come first'(page, {submissions}) {
    const seconds = submissions.map(({seconds}) => seconds).filter((value) => value !== null).sort((a, b) => b - a);
    assert.deepEqual(await textsOf(page, '#slowest .times'), seconds.map((value) => `${Math.round(value)} s`));
  },

  async 'it has landmarks and headings'(page) {
    for (const role of ['banner', 'main']) assert.equal(await page.getByRole(role).count(), 1, role);
    assert.equal(await page.getByRole('heading', {level: 1}).count(), 1);
  },

  async 'nothing is wider than the window, from 320 pixels to 1920'(page) {
    await assertFitsEveryWindow(page);
  },

  async 'it prints light'(page) {
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    const [red] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert(red > 200);
  },

  async 'axe finds nothing, in all colors'(page) {
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({colorScheme});
      await page.setViewportSize(largeWindow);
      await assertNoAxeViolations(page, colorScheme);
      await page.setViewportSize({width: 375, height: 800});
      await assertNoAxeViolations(page, `${colorScheme}, narrow`);
    }
  },
};

await testPages({readPage, reset, tests});
