// Drives the pages that grading writes for students, in a browser without a screen: node student_page_test.mjs REPORT.html...
// raylab-sample-reports writes some, with hostile text in them.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {assertFitsEveryWindow, assertNoAxeViolations, blockOf, drawn, largeWindow, press, testPages, text} from './browser.mjs';

function readPage(path) {
  const html = readFileSync(path);
  const report = JSON.parse(blockOf(html, 'report'));
  const tasks = report.stages.flatMap((stage) => stage.tasks);
  const images = report.stages.flatMap((stage) => stage.images);
  return {html, report, tasks, images, drawnImages: images.filter(({image, reference}) => image && reference)};
}

async function reset(page) {
  await page.emulateMedia({colorScheme: 'light', media: 'screen'});
  await page.setViewportSize(largeWindow);
  await page.reload();
  await page.waitForFunction(() => !document.querySelector('.picture:empty'));
  await page.evaluate(() => document.querySelectorAll('details').forEach((folded) => { folded.open = true; }));
  await drawn(page);
}

const textsOf = (page, selector) => page.locator(selector).evaluateAll((all) => all.map((element) => element.textContent));
const points = ({got, most}) => `${Math.round(1000 * got) / 1000} of ${Math.round(1000 * most) / 1000}`;

// Of the first pair of images that there is.
const viewer = (page) => page.locator('.picture', {has: page.locator('.modes')}).first();
const picturesOf = (page) => viewer(page).locator('canvas:visible').evaluateAll((all) => all.map((canvas) => canvas.toDataURL()));

/** The mean color of a square in the middle of each canvas that is shown. Read from a copy: see page_test.mjs. */
const meansOf = (page) => viewer(page).locator('canvas:visible').evaluateAll((all) => all.map((canvas) => {
  const size = Math.round(canvas.height / 2);
  const copy = new OffscreenCanvas(size, size).getContext('2d', {willReadFrequently: true});
  copy.drawImage(canvas, -Math.round((canvas.width - size) / 2), -Math.round(canvas.height / 4));
  const sums = [0, 0, 0];
  for (const [k, component] of copy.getImageData(0, 0, size, size).data.entries())
    if (k % 4 < 3) sums[k % 4] += component;
  return sums.map((sum) => sum / (size * size));
}));
const distance = (a, b) => Math.max(...a.map((component, k) => Math.abs(component - b[k])));

async function middleOf(locator) {
  await locator.scrollIntoViewIfNeeded();
  const box = await locator.boundingBox();
  return {x: box.x + box.width / 2, y: box.y + box.height / 2, width: box.width};
}

async function assertAllChanged(page, act) {
  const before = await picturesOf(page);
  await act();
  await drawn(page);
  const after = await picturesOf(page);
  assert.equal(after.length, before.length);
  for (const [k, picture] of after.entries()) assert.notEqual(picture, before[k], `view ${k}`);
}

async function swiped(page) {
  await viewer(page).locator('input[value=swipe]').check({force: true});
  await drawn(page);
  return viewer(page).locator('.divider');
}

const tests = {
  async 'the points are there at a glance'(page, {report}) {
    assert.equal(await text(page, '#points'), `${points(report.points)} points`);
    assert.equal(await page.locator('#overview li').count(), report.stages.length);
    for (const [k, stage] of report.stages.entries())
      assert((await textsOf(page, '#overview li'))[k].endsWith(points(stage.points)));
    assert.equal(await page.isVisible('#again'), report.needsNewRun);
  },

  async 'each task and image has its verdict and its points'(page, {tasks, images}) {
    const verdicts = await textsOf(page, '.part .pill');
    assert.deepEqual(
        verdicts.toSorted(), [...tasks, ...images].map(({verdict}) => verdict.replaceAll('_', ' ')).toSorted());
    const given = (await textsOf(page, '.part .points')).filter(Boolean);
    assert.deepEqual(given, tasks.map((task) => points(task.points)));
  },

  async 'whatever a submission wrote is shown as it is, as text'(page, {report, tasks, images}) {
    const shown = await textsOf(page, 'pre');
    const written = tasks.flatMap(({call, failed, hint}) => [call, hint, ...failed.map(({text}) => text)]);
    for (const wanted of [...written, ...images.map(({difference}) => difference)].filter(Boolean))
      assert(shown.includes(wanted), wanted);
    assert.equal(await page.locator('#id').textContent(), report.id);
    assert.equal(await page.title(), `raylab: results of ${report.id}`.replace(/\s+/g, ' ').trim());
    assert.equal(await page.locator('script').count(), 2);
    assert.equal(await page.locator('img').count(), 0);
  },

  async 'nothing of the course’s own tests and images is in the file'(page, {html, report}) {
    assert(!html.includes('SECRET'));
    for (const [k, stage] of report.stages.entries())
      assert((await textsOf(page, '.stage'))[k].includes(`Course's own checks: ${points(stage.course)}`));
  },

  async 'hints are folded, and open by keyboard'(page, {tasks}) {
    const hinted = tasks.filter(({hint}) => hint).length;
    const hints = page.locator('details', {has: page.getByText('Hint', {exact: true})});
    assert.equal(await hints.count(), hinted);
    if (hinted === 0) return;
    await page.reload();
    assert(!await hints.first().locator('pre').isVisible());
    await hints.first().locator('summary').focus();
    await press(page, 'Enter');
    assert(await hints.first().locator('pre').isVisible());
  },

  async 'what the compiler says is open where it refuses the file'(page, {report}) {
    await page.reload();
    for (const {number, compiler, tasks} of report.stages.filter(({compiler}) => compiler)) {
      const messages = page.locator(`#stage-${number} > details pre`);
      assert.equal(await messages.textContent(), compiler);
      assert.equal(await messages.isVisible(), tasks.some(({verdict}) => verdict === 'does_not_compile'));
    }
  },

  async 'images stand beside the reference and their difference; what is missing says so'(page, {images}) {
    const views = images.map(({image, reference, heat}) => (image || reference ? 2 + (heat ? 1 : 0) : 1));
    const shown = await page.locator('.picture').evaluateAll(
        (all) => all.map((box) => [...box.querySelectorAll('.view')].filter((view) => !view.hidden).length));
    assert.deepEqual(shown, views);
    const missing = images.flatMap(({image, reference}) => (image || reference ? [image, reference] : ['']));
    assert.equal(await page.locator('.missing').count(), missing.filter((source) => !source).length);
  },

  async 'a wheel in one view zooms all, a drag moves all, Fit shows the whole again'(page, {drawnImages}) {
    if (drawnImages.length === 0) return;
    const whole = await picturesOf(page);
    const place = await middleOf(viewer(page).locator('.frame').first());
    await page.mouse.move(place.x, place.y);
    await assertAllChanged(page, () => page.mouse.wheel(0, -600));
    assert.notEqual(await viewer(page).locator('.reading').innerText(), '100 %');
    await assertAllChanged(page, async () => {
      await page.mouse.down();
      await page.mouse.move(place.x + 40, place.y + 25, {steps: 4});
      await page.mouse.up();
    });
    await viewer(page).getByRole('button', {name: 'Fit'}).click();
    await drawn(page);
    assert.deepEqual(await picturesOf(page), whole);
  },

  async 'keys zoom and move, buttons zoom'(page, {drawnImages}) {
    if (drawnImages.length === 0) return;
    await viewer(page).locator('.views').focus();
    await assertAllChanged(page, () => press(page, '+', '+'));
    for (const key of ['ArrowLeft', 'ArrowDown', '-', '0'])
      await assertAllChanged(page, () => press(page, key));
    await assertAllChanged(page, () => viewer(page).getByRole('button', {name: 'Zoom in'}).click());
    await assertAllChanged(page, () => viewer(page).getByRole('button', {name: 'Zoom out'}).click());
  },

  async 'the divider of a swipe moves by keyboard and by pointer'(page, {drawnImages}) {
    if (drawnImages.length === 0) return;
    const divider = await swiped(page);
    assert.equal(await viewer(page).locator('canvas:visible').count(), 1);
    await divider.focus();
    await assertAllChanged(page, () => press(page, ...Array(20).fill('ArrowLeft')));
    assert.equal(await divider.inputValue(), '40');
    const place = await middleOf(divider);
    const thumb = place.x - 0.1 * (place.width - 24);
    await page.mouse.move(thumb, place.y);
    await assertAllChanged(page, async () => {
      await page.mouse.down();
      await page.mouse.move(thumb + 0.3 * place.width, place.y, {steps: 4});
      await page.mouse.up();
    });
    assert(Math.abs(await divider.inputValue() - 70) < 3, await divider.inputValue());
  },

  async 'a swipe shows yours left of the divider and the reference right of it'(page, {drawnImages}) {
    if (drawnImages.length === 0) return;
    const [yours, reference] = await meansOf(page);
    const divider = await swiped(page);
    for (const [key, near, far] of [['Home', reference, yours], ['End', yours, reference]]) {
      await divider.focus();
      await press(page, key);
      await drawn(page);
      const [mean] = await meansOf(page);
      assert(distance(mean, near) < 8 && distance(mean, near) <= distance(mean, far), `${key}: ${mean}`);
    }
  },

  async 'it has landmarks and headings'(page, {report}) {
    for (const role of ['banner', 'main', 'contentinfo', 'navigation'])
      assert.equal(await page.getByRole(role).count(), 1, role);
    assert.equal(await page.getByRole('heading', {level: 1}).count(), 1);
    assert.equal(await page.getByRole('heading', {level: 2}).count(), report.stages.length);
  },

  async 'nothing is wider than the window, from 320 pixels to 1920'(page) {
    await assertFitsEveryWindow(page);
  },

  async 'it prints light, without controls, with its hints'(page, {tasks}) {
    await page.reload();
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    assert.equal(await page.locator('.toolbar:visible').count(), 0);
    const [red] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert(red > 200);
    for (const {hint} of tasks.filter(({hint}) => hint))
      assert(await page.locator('pre').filter({hasText: hint.trim().split('\n').pop()}).first().isVisible());
  },

  async 'axe finds nothing, in all modes and colors'(page, {drawnImages}) {
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({colorScheme});
      await page.setViewportSize(largeWindow);
      await assertNoAxeViolations(page, colorScheme);
      if (drawnImages.length > 0) await swiped(page);
      await page.setViewportSize({width: 375, height: 800});
      await assertNoAxeViolations(page, `${colorScheme}, swipe, narrow`);
    }
  },
};

await testPages({readPage, reset, tests});
