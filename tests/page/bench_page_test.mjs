// Drives pages that `raylab bench --out` wrote, in a browser without a screen: node bench_page_test.mjs PAGE.html...

import assert from 'node:assert/strict';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {assertNoAxeViolations, blockOf, drawn, largeWindow, openPage, press, testPages, text} from './browser.mjs';

// ----------------------------------------------------------------------------- what must be shown, from the data alone

function readPage(path) {
  const html = readFileSync(path);
  return {html, report: JSON.parse(blockOf(html, 'report'))};
}

const list = (value) => value ?? [];
const isTimed = (entry) => Number.isFinite(entry.mpixels_per_second?.median);
const variantsOf = (scene, aa) => list(scene.variants).filter((variant) => variant.aa === aa);
const measured = (scene, aa) => variantsOf(scene, aa).filter((variant) => isTimed(variant) && variant.arithmetic);
const sum = (numbers) => numbers.reduce((total, number) => total + number, 0);

/** How many marks the strips of a task have: each implementation's worst of the ordinary and of the hard families. */
function stripMarks(task) {
  const kinds = task.families.flatMap(
      ({hard, results}) => results.filter(({ulps}) => ulps).map(({by, precision}) => `${hard} ${by} ${precision}`));
  return new Set(kinds).size;
}

// ---------------------------------------------------------------------------------------------------- driving the page

const sections = ['pick', 'images', 'kernels', 'growth', 'edges', 'run'];
const panel = (page, section, title) =>
    page.locator(`#${section} .panel`, {has: page.getByRole('heading', {name: title, exact: true})});
const marksIn = (locator) => locator.locator('.mark').count();

async function reset(page) {
  await page.emulateMedia({colorScheme: 'light', media: 'screen', contrast: 'no-preference', forcedColors: 'none'});
  await page.setViewportSize(largeWindow);
  await page.mouse.move(1, 1);
  await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = false;
    for (const select of document.querySelectorAll('select')) {
      select.selectedIndex = Math.max(0, [...select.options].findIndex(({value}) => value === 'none'));
      select.dispatchEvent(new Event('change'));
    }
    document.activeElement.blur();
    window.scrollTo(0, 0);
  });
  await drawn(page);
}

async function choose(page, id, value) {
  if (await page.locator(`#${id}`).count()) await page.selectOption(`#${id}`, value);
  await drawn(page);
}

/** Pairs of texts in one plot of which one covers the other, and texts that reach out of their panel. */
const misplacedTexts = (page) => page.evaluate(() => {
  const covers = (a, b) =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > 3 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 5;
  return [...document.querySelectorAll('.plot svg')].flatMap((svg) => {
    const texts = [...svg.querySelectorAll('text')].map((element) => [element.textContent, element.getBoundingClientRect()]);
    const panel = svg.closest('.panel').getBoundingClientRect();
    const isOut = ([, box]) => box.left < panel.left || box.right > panel.right;
    const outside = texts.filter(isOut).map(([text]) => `${svg.getAttribute('aria-label')}: ${text} is outside`);
    return outside.concat(texts.flatMap(
        ([text, box], k) => texts.slice(k + 1)
                                .filter(([, other]) => covers(box, other))
                                .map(([other]) => `${svg.getAttribute('aria-label')}: ${text} / ${other}`)));
  });
});

/** Opens the page with another report in it. */
async function withReport(browser, html, report, test) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  const path = join(folder, 'report.html');
  const json = JSON.stringify(report).replaceAll('<', '\\u003c');
  writeFileSync(
      path, html.toString('utf8').replace(/(id="report">).*?(<\/script>)/s, (_, start, end) => start + json + end));
  const {page, unwanted} = await openPage(browser, path);
  try {
    await drawn(page);
    await page.evaluate(() => {
      for (const details of document.querySelectorAll('details')) details.open = true;
    });
    await drawn(page);
    await test(page);
    assert.deepEqual(unwanted, []);
  } finally {
    await page.close();
    rmSync(folder, {recursive: true});
  }
}

/** A report with every leaf replaced that `change` returns something else for. */
function changed(value, change) {
  if (Array.isArray(value)) return value.map((part) => changed(part, change));
  if (value === null || typeof value !== 'object') return change(value);
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, changed(part, change)]));
}

// ----------------------------------------------------------------------------------------------------------- the tests

const tests = {
  async 'every section has its heading, and what is not measured is said to be'(page, {report}) {
    for (const id of sections) {
      assert.equal(await page.locator(`#${id} > h2`).count(), 1, id);
      assert((await text(page, `#${id} > div`)).length > 0, id);
    }
    for (const id of ['kernels', 'growth', 'edges'])
      assert.equal(
          await page.locator(`#${id} > div > .missing`).count(), report[id] && Object.keys(report[id]).length ? 0 : 1, id);
  },

  async 'the top says where and when it was measured'(page, {report: {header}}) {
    const machine = await text(page, '#machine');
    for (const part of [header.processor, header.commit, header.mode].filter(Boolean)) assert(machine.includes(part), part);
    assert((await text(page, '#run .command')).includes(header.command));
  },

  async 'the choices are there in full'(page, {report}) {
    const shown = await page.locator('#choices li').allInnerTexts();
    assert.equal(shown.length, list(report.choices).length);
    const words = (string) => string.split(/\s+/).join(' ');
    for (const [k, choice] of list(report.choices).entries())
      for (const part of [choice.need, choice.bound, choice.pick, choice.sentence, choice.hard_sentence].filter(Boolean))
        assert(words(shown[k]).includes(words(part)), part);
  },

  async 'the images\' plots have a point for all that was measured, in every scene'(page, {report}) {
    for (const scene of list(report.images?.scenes)) {
      await choose(page, 'scene', scene.scene);
      for (const aa of new Set(scene.variants.map((variant) => variant.aa))) {
        await choose(page, 'aa', aa);
        assert.equal(await marksIn(panel(page, 'images', 'Arithmetic')), measured(scene, aa).length, `${scene.scene} ${aa}`);
        const rows = panel(page, 'images', 'Arithmetic').locator('details').first().locator('tbody tr');
        assert.equal(await rows.count(), variantsOf(scene, aa).length);
      }
      assert.equal(
          await marksIn(panel(page, 'images', 'Sampling')), list(scene.sampling).filter(isTimed).length, scene.scene);
      const finite = list(scene.model).filter(({error}) => Number.isFinite(error?.rmse));
      assert.equal(await marksIn(panel(page, 'images', 'Model')), finite.length, scene.scene);
    }
  },

  async 'every task has its strips, and opens to its families\' numbers'(page, {report}) {
    const tasks = list(report.kernels);
    assert.equal(await page.locator('#kernels summary').count(), tasks.length);
    for (const [k, task] of tasks.entries()) {
      const row = page.locator('#kernels .tasks > details').nth(k);
      assert.equal(await row.locator('summary .shape').count(), stripMarks(task), task.name);
      await row.locator('summary').click();
      await drawn(page);
      assert.equal(await row.locator('tbody tr').count(), sum(task.families.map(({results}) => results.length)), task.name);
      assert.equal(await row.locator('.hard').count(), task.families.filter(({hard}) => hard).length, task.name);
    }
  },

  async 'cost, growth and edges have a point for all that was measured'(page, {report}) {
    for (const series of list(report.growth?.series)) {
      const points = series.curves.flatMap((curve) => curve.points).filter(({seconds}) => Number.isFinite(seconds?.median));
      assert.equal(await marksIn(panel(page, 'growth', series.title)), points.length, series.title);
    }
    if (list(report.growth?.features).length)
      assert.equal(
          await marksIn(panel(page, 'growth', 'What each feature costs')),
          report.growth.features.filter((feature) => [feature.with, feature.without].every((timing) => timing?.median > 0))
              .length);
    assert.equal(await marksIn(page.locator('#edges')), sum(list(report.edges?.patterns).map(({points}) => points.length)));
  },

  async 'a plot is one stop of the keyboard, and its points tell their numbers'(page) {
    const plots = page.locator('.plot svg');
    for (let k = 0; k < await plots.count(); ++k) {
      const plot = plots.nth(k);
      assert.equal(await plot.locator('.mark[tabindex="0"]').count(), 1);
      await plot.locator('.mark[tabindex="0"]').focus();
      for (let step = 0; step < Math.min(4, await plot.locator('.mark').count()); ++step) {
        await drawn(page);
        const name = await page.evaluate(() => document.activeElement.getAttribute('aria-label'));
        assert.equal((await page.locator('#tip > *').allTextContents()).join(', '), name);
        assert(await page.isVisible('#tip'), name);
        await press(page, 'ArrowRight');
      }
      await press(page, 'Escape');
      assert(!await page.isVisible('#tip'));
    }
  },

  async 'a point tells its numbers to the pointer too'(page) {
    const plots = page.locator('.plot svg');
    for (let k = 0; k < await plots.count(); ++k) {
      await plots.nth(k).scrollIntoViewIfNeeded();
      await drawn(page);
      const box = await plots.nth(k).locator('.mark .ring').last().boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      assert(await page.isVisible('#tip'), `plot ${k}`);
      await page.mouse.move(1, 1);
      assert(!await page.isVisible('#tip'), `plot ${k}`);
    }
  },

  async 'no text of a plot covers another, in every scene'(page, {report}) {
    for (const width of [1400, 768, 390, 320]) {
      await page.setViewportSize({width, height: 900});
      for (const {scene} of list(report.images?.scenes)) {
        await choose(page, 'scene', scene);
        assert.deepEqual(await misplacedTexts(page), [], `${width}, ${scene}`);
      }
    }
  },

  async 'nothing is wider than the window, from 320 pixels to 3840, opened or not'(page) {
    for (const open of [false, true]) {
      await page.evaluate((isOpen) => {
        for (const details of document.querySelectorAll('details')) details.open = isOpen;
      }, open);
      for (const width of [320, 390, 768, 1024, 1440, 3840]) {
        await page.setViewportSize({width, height: 900});
        await drawn(page);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        assert(wide <= 0, `${width}: ${wide} too wide`);
      }
    }
  },

  async 'it prints light, with its plots'(page) {
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    assert(!await page.isVisible('nav') && await page.isVisible('#choices'));
    const [red] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert(red > 200);
  },

  async 'axe finds nothing'(page) {
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({colorScheme});
      for (const width of [1200, 320]) {
        await page.setViewportSize({width, height: 800});
        await drawn(page);
        await assertNoAxeViolations(page, `${colorScheme}, ${width}`);
      }
    }
    await page.evaluate(() => {
      for (const details of document.querySelectorAll('details')) details.open = true;
    });
    await drawn(page);
    await assertNoAxeViolations(page, 'dark, all opened');
  },

  async 'a report of nothing is a page'(_, {html}, browser) {
    await withReport(browser, html, {}, async (page) => {
      assert.equal(await page.locator('section > div > .missing, #choices > .missing').count(), 5);
    });
  },

  async 'a report that lacks a section or its numbers is a page'(_, {html, report}, browser) {
    for (const id of ['header', 'noise', 'choices', 'images', 'kernels', 'growth', 'edges'])
      await withReport(browser, html, {...report, [id]: null}, async (page) => {
        assert((await text(page, '#run')).length > 0, id);
      });
    const noNumbers = changed(report, (value) => (typeof value === 'number' ? null : value));
    await withReport(browser, html, noNumbers, async (page) => assert((await text(page, '#run')).length > 0));
  },

  async 'no text in a report becomes markup'(_, {html, report}, browser) {
    const hostile = '</script><img src=x onerror=alert(1)><b>&amp;';
    const all = changed(report, (value) => (typeof value === 'string' ? hostile : value));
    await withReport(browser, html, all, async (page) => {
      assert.equal(await page.locator('img').count(), 0);
      assert((await page.locator('#choices').textContent()).includes(report.choices?.length ? hostile : ''));
    });
  },
};

await testPages({readPage, reset, tests});
