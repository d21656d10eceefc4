// Drives pages that `raylab diff --out` wrote, in a browser without a screen: node page_test.mjs PAGE.html...

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {assertNoAxeViolations, blockOf, drawn, largeWindow, press, testPages, text} from './browser.mjs';

// ------------------------------------------------------------------- what the page holds, read without the page's help

/** Lines of base64, each of which may be padded, as one buffer. */
function bytesOf(html, id) {
  const block = blockOf(html, id);
  return block === null ? null : Buffer.concat(block.split('\n').filter(Boolean).map((line) => Buffer.from(line, 'base64')));
}

function floatsOf(html, id) {
  const bytes = bytesOf(html, id);
  return bytes && new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

function readPage(path) {
  const html = readFileSync(path);
  const report = JSON.parse(blockOf(html, 'report'));
  const objects = bytesOf(html, 'object-data');
  return {
    report,
    image: floatsOf(html, 'image-data'),
    reference: floatsOf(html, 'reference-data'),
    ranges: rangesOf(bytesOf(html, 'ranges-data')),
    error: floatsOf(html, 'error-data'),
    verdict: bytesOf(html, 'verdict-data'),
    margin: floatsOf(html, 'margin-data'),
    sensitivity: floatsOf(html, 'sensitivity-data'),
    objectAt: (k) => objects.readInt32LE(4 * k),
  };
}

function rangesOf(bytes) {
  const six = [0, 1, 2, 3, 4, 5];
  const ranges = new Map();
  for (let at = 0; at < bytes.length; at += 28)
    ranges.set(bytes.readUInt32LE(at), six.map((k) => bytes.readFloatLE(at + 4 + 4 * k)));
  return ranges;
}

const triple = (numbers, k) => [...numbers.subarray(3 * k, 3 * k + 3)];
const byte = (component) => Math.floor(255 * Math.min(1, Math.max(0, component)) + 0.5);

/** What a view must show of a pixel: three bytes, or null for "a color that is not in the map". */
function expectedColor(data, view, k, gain = 1) {
  if (view === 'difference') {
    const error = data.error[k];
    if (!Number.isFinite(error)) return null;
    return data.report.colorMap[Math.round(255 * Math.min(1, Math.max(0, 1 + Math.log10(error) / 4)))];
  }
  const color = triple(view === 'yours' ? data.image : data.reference, k);
  return color.every(Number.isFinite) ? color.map((component) => byte(component * gain)) : null;
}

// ---------------------------------------------------------------------------------------------------- driving the page

async function place(page) {
  await drawn(page);
  const [column, row] = (await text(page, '#place')).match(/\d+/g).map(Number);
  return {column, row};
}

async function zoomOf(page) {
  await drawn(page);
  return Number((await text(page, '#zoom')).replace('×', ''));
}

const focusViews = (page) => page.focus('#views');

async function reset(page) {
  await page.emulateMedia({
    colorScheme: 'light',
    reducedMotion: 'no-preference',
    contrast: 'no-preference',
    forcedColors: 'none',
    media: 'screen'
  });
  await page.setViewportSize(largeWindow);
  await page.evaluate(() => document.getElementById('keys').close());
  await page.mouse.move(1, 1);
  await page.check('#mode-side', {force: true});
  await page.click('#fit');
  await page.click('#exposure-reset');
  await page.check('#marks');
  await page.evaluate(() => {
    document.activeElement.blur();
    window.scrollTo(0, 0);
  });
  await drawn(page);
}

const showWorst = (page, number) => page.locator('#worst tr').nth(number).getByRole('button').click();

async function boxOf(page, view) {
  const frame = page.locator(`#view-${view} .frame`);
  await frame.scrollIntoViewIfNeeded();
  return frame.boundingBox();
}

async function wheelAt(page, view, fractionX, fractionY, delta) {
  const box = await boxOf(page, view);
  await page.mouse.move(box.x + box.width * fractionX, box.y + box.height * fractionY);
  await page.mouse.wheel(0, delta);
  await drawn(page);
}

/** Enlarges the pixels until they are at least so many CSS pixels wide. */
async function enlarge(page, view, size) {
  for (let k = 0; k < 60 && await zoomOf(page) < size; ++k) await wheelAt(page, view, 0.5, 0.5, -200);
}

async function pixelUnder(page, point) {
  await page.mouse.move(point.x, point.y);
  return place(page);
}

/** The color that a canvas shows at a point. Read from a copy: browsers treat a canvas that is read often in another way. */
const readCanvas = (page, view, point) => page.evaluate(([id, {x, y}]) => {
  const canvas = document.querySelector(`#view-${id} canvas`);
  const box = canvas.getBoundingClientRect();
  const scale = canvas.width / box.width;
  const copy = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
  copy.drawImage(canvas, -Math.floor((x - box.left) * scale), -Math.floor((y - box.top) * scale));
  return [...copy.getImageData(0, 0, 1, 1).data].slice(0, 3);
}, [view, point]);

/** Points of a view on its image, which may leave margins in it; as fractions of what is seen of the image. */
async function pointsIn(page, data, view, fractions) {
  const box = await boxOf(page, view);
  const zoom = await zoomOf(page);
  const along = (start, length, size, fraction) =>
      Math.floor(start + length / 2 + (fraction - 0.5) * 0.98 * Math.min(length, size * zoom)) + 0.5;
  return fractions.map(
      ([fx, fy]) =>
          ({x: along(box.x, box.width, data.report.width, fx), y: along(box.y, box.height, data.report.height, fy)}));
}

/** What a view shows at points that are not at a pixel's edge: numbers of points, pixels as the page names them, colors. */
async function sample(page, data, view, fractions) {
  const samples = [];
  for (const [spot, point] of (await pointsIn(page, data, view, fractions)).entries()) {
    const around = [];
    for (const shift of [-2, 2, 0]) around.push(await pixelUnder(page, {x: point.x + shift, y: point.y + shift}));
    await page.mouse.move(1, 1);  // away, since the pixel under the pointer is marked
    await drawn(page);
    if (new Set(around.map((pixel) => JSON.stringify(pixel))).size === 1)
      samples.push({spot, pixel: around[0], color: await readCanvas(page, view, point)});
  }
  assert(samples.length > 0);
  return samples;
}

const spots = [[0.5, 0.5], [0.47, 0.53], [0.3, 0.4], [0.62, 0.31], [0.7, 0.72], [0.41, 0.66]];

function assertColors(data, view, samples, gain = 1) {
  for (const {pixel, color} of samples) {
    const expected = expectedColor(data, view, pixel.row * data.report.width + pixel.column, gain);
    if (expected)
      assert.deepEqual(color, expected, `${view} at column ${pixel.column}, row ${pixel.row}`);
    else
      assert(!data.report.colorMap.some((other) => other.join() === color.join()), `${view}: ${color} is in the map`);
  }
}

/** Views whose marks and cursor do not cover what is looked at. */
async function withPlainViews(page, data) {
  await page.uncheck('#marks');
  await focusViews(page);
  for (let k = 0; k < Math.ceil(Math.max(data.report.width, data.report.height) / 10) && k < 250; ++k)
    await press(page, 'Shift+ArrowLeft', 'Shift+ArrowUp');
}

/** A number as the page writes it. */
function numberOf(written) {
  if (written === 'NaN') return NaN;
  if (written.endsWith('infinite')) return written.startsWith('-') ? -Infinity : Infinity;
  return Number(written);
}

function assertNumbers(written, expected, what) {
  assert.equal(written.length, expected.length, what);
  for (const [k, value] of expected.entries()) {
    const number = numberOf(written[k]);
    const close = Object.is(number, value) || number === value || Math.abs(number - value) <= 1e-6 * Math.abs(value);
    assert(close, `${what}: ${written[k]} should be ${value}`);
  }
}

function objectName({planes, spheres}, id) {
  if (id < 0) return 'background';
  if (id < planes) return `plane[${id}]`;
  return id < planes + spheres ? `sphere[${id - planes}]` : `cloud sphere ${id - planes - spheres}`;
}

/** Checks all numbers in the panel "Pixel" against the data. */
async function assertPanel(page, data) {
  const {column, row} = await place(page);
  const k = row * data.report.width + column;
  const rows =
      await page.locator('#values tr')
          .evaluateAll((lines) => lines.map((line) => [...line.querySelectorAll('td')].map((cell) => cell.textContent)));
  const range = data.ranges.get(k) ?? [...triple(data.reference, k), ...triple(data.reference, k)];
  assertNumbers(rows[0], triple(data.image, k), 'yours');
  assertNumbers(rows[1], triple(data.reference, k), 'reference');
  assertNumbers(rows[2], range.slice(0, 3), 'least');
  assertNumbers(rows[3], range.slice(3), 'greatest');
  const facts = Object.fromEntries(await page.locator('#facts').evaluate(
      (list) => [...list.querySelectorAll('dt')].map((name) => [name.textContent, name.nextElementSibling.textContent])));
  assertNumbers([facts.Error], [data.error[k]], 'error');
  assert.match(facts.Verdict, [/^within its range$/, /rounding may decide.*not counted/, /^outside/][data.verdict[k]]);
  assert.equal('Object' in facts, data.report.hasWord);
  if (!data.report.hasWord) return;
  assertNumbers([facts.Margin, facts.Sensitivity], [data.margin[k], data.sensitivity[k]], 'margin and sensitivity');
  assert.equal(facts.Object, objectName(data.report, data.objectAt(k)));
}

// ----------------------------------------------------------------------------------------------------------- the tests

const tests = {
  async 'the header says the verdict in words, the texts as they were given, and the numbers'(page, {report}) {
    assert.equal(await text(page, '#verdict .word'), report.comparison.verdict === 'same' ? 'Same' : 'Differs');
    const shown = (selector) => page.locator(selector).evaluate((element) => element.textContent);
    assert.equal(await shown('#title'), report.title);
    assert((await shown('#names')).includes(report.imageName) && (await shown('#names')).includes(report.referenceName));
    assert.equal(await page.locator('#findings li').count(), report.comparison.findings.length);
    for (const [k, {text}] of report.comparison.findings.entries())
      assert.equal(await shown(`#findings li >> nth=${k}`), text);
    const values = await page.locator('#stats .value').allTextContents();
    const {outside, densest, at_decision: atDecision, non_finite: nonFinite, max_error: maxError, mean_error: meanError,
      rmse, psnr} = report.comparison;
    assert.deepEqual(
        values.slice(0, 4), [outside, densest, atDecision, nonFinite].map((count) => count.toLocaleString('en')));
    for (const [k, number] of [maxError, meanError, rmse, psnr].entries()) {
      const value = numberOf(values[4 + k].replace(' dB', ''));
      assert(Object.is(value, Number(number)) || Math.abs(value - number) <= 1e-3 * Math.abs(number), values[4 + k]);
    }
  },

  async 'the three views show the numbers as colors, and are linked'(page, data) {
    await withPlainViews(page, data);
    await enlarge(page, 'yours', 24);
    const seen = new Map();
    for (const view of ['yours', 'reference', 'difference']) {
      const samples = await sample(page, data, view, spots);
      assertColors(data, view, samples);
      for (const {spot, pixel} of samples) {
        assert.deepEqual(pixel, seen.get(spot) ?? pixel, view);
        seen.set(spot, pixel);
      }
    }
  },

  async 'the difference has the heat map\'s colors around the worst pixels'(page, data) {
    if (data.report.comparison.worst.length === 0) return;
    await showWorst(page, 0);
    await page.uncheck('#marks');
    await enlarge(page, 'difference', 24);
    const near = await sample(page, data, 'difference', spots);
    assertColors(data, 'difference', near.filter(({pixel}) => data.error[pixel.row * data.report.width + pixel.column] > 0));
  },

  async 'exposure multiplies yours and reference, and resets'(page, data) {
    await withPlainViews(page, data);
    await enlarge(page, 'yours', 24);
    await press(page, 'e', 'e');
    assert.equal(await text(page, '#stops'), '+1 stop');
    for (const view of ['yours', 'reference']) assertColors(data, view, await sample(page, data, view, spots), 2);
    assertColors(data, 'difference', await sample(page, data, 'difference', spots));
    await press(page, 'E', 'E', 'E');
    assert.equal(await text(page, '#stops'), '-0.5 stops');
    await page.click('#exposure-reset');
    assertColors(data, 'yours', await sample(page, data, 'yours', spots));
  },

  async 'a pixel that is no finite number has a color that is not in the map'(page, data) {
    const {width, height, comparison: {worst}} = data.report;
    const fromEdge = ({column, row}) => Math.min(column, row, width - 1 - column, height - 1 - row);
    const notFinite = worst.filter(({image}) => image.some((component) => !Number.isFinite(Number(component))));
    if (notFinite.length === 0) return;
    const innermost =
        notFinite.reduce((best, next) => (fromEdge(next) > fromEdge(best) ? next : best));  // it can be in the middle
    await showWorst(page, worst.indexOf(innermost));
    await page.uncheck('#marks');
    await enlarge(page, 'yours', 24);
    assertColors(data, 'difference', await sample(page, data, 'difference', [[0.5, 0.5]]));
    assertColors(data, 'yours', await sample(page, data, 'yours', [[0.5, 0.5]]));
  },

  async 'the panel has all numbers of the pixel under the pointer'(page, data) {
    for (const {x, y} of await pointsIn(page, data, 'reference', spots)) {
      await page.mouse.move(x, y);
      await assertPanel(page, data);
    }
  },

  async 'the panel has the range of a pixel whose range is more than a value'(page, data) {
    const {width} = data.report;
    const cursor = await place(page);
    const away = (k) => Math.abs(k % width - cursor.column) + Math.abs(Math.floor(k / width) - cursor.row);
    const indices = [...data.ranges.keys()];
    if (indices.length === 0) return;
    const nearest = indices.reduce((best, next) => (away(next) < away(best) ? next : best));
    if (away(nearest) > 500) return;  // too far to walk
    const steps = (count, back, forth) => Array(Math.abs(count)).fill(count < 0 ? back : forth);
    await focusViews(page);
    await press(
        page, ...steps(nearest % width - cursor.column, 'ArrowLeft', 'ArrowRight'),
        ...steps(Math.floor(nearest / width) - cursor.row, 'ArrowUp', 'ArrowDown'));
    assert.deepEqual(await place(page), {column: nearest % width, row: Math.floor(nearest / width)});
    await assertPanel(page, data);
  },

  async 'the panel has all numbers of the worst pixels'(page, data) {
    for (let k = 0; k < data.report.comparison.worst.length; ++k) {
      await showWorst(page, k);
      const {column, row} = data.report.comparison.worst[k];
      assert.deepEqual(await place(page), {column, row});
      await assertPanel(page, data);
    }
  },

  async 'arrow keys move the cursor in the views, by one and by ten, and stop at the edge'(page, data) {
    const {width, height} = data.report;
    const within = ({column, row}) =>
        ({column: Math.min(width - 1, Math.max(0, column)), row: Math.min(height - 1, Math.max(0, row))});
    await focusViews(page);
    let expected = await place(page);
    for (const [key, columns, rows] of [
             ['ArrowLeft', -1, 0], ['ArrowUp', 0, -1], ['Shift+ArrowRight', 10, 0], ['Shift+ArrowDown', 0, 10],
             ['ArrowRight', 1, 0], ['ArrowDown', 0, 1], ['Shift+ArrowLeft', -10, 0], ['Shift+ArrowUp', 0, -10]]) {
      await press(page, key);
      expected = within({column: expected.column + columns, row: expected.row + rows});
      assert.deepEqual(await place(page), expected, key);
    }
    for (let k = 0; k <= width / 10; ++k) await press(page, 'Shift+ArrowLeft');
    assert.equal((await place(page)).column, 0);
    await assertPanel(page, data);
  },

  async 'arrow keys stay with the controls that need them'(page) {
    const before = await place(page);
    await page.focus('#exposure');
    await press(page, 'ArrowRight');
    assert.equal(await text(page, '#stops'), '+0.25 stops');
    await page.focus('#mode-side');
    await press(page, 'ArrowRight');
    assert(await page.isChecked('#mode-yours'));
    assert.deepEqual(await place(page), before);
  },

  async 'plus and minus zoom, 0 fits; the wheel keeps the pixel under the pointer'(page, data) {
    const fitting = await zoomOf(page);
    await press(page, '+', '+');
    const zoomed = await zoomOf(page);
    assert(zoomed > fitting || fitting >= 96, `${zoomed} > ${fitting}`);
    await press(page, '-', '-');
    assert.equal(await zoomOf(page), fitting);
    await enlarge(page, 'yours', 8);
    const enlarged = await zoomOf(page);
    const [{x, y}] = await pointsIn(page, data, 'yours', [[0.5, 0.4]]);
    const point = {x: Math.floor(x), y: Math.floor(y)};  // the wheel's events have whole coordinates
    const before = await pixelUnder(page, point);
    const scroll = await page.evaluate(() => window.scrollY);
    await page.mouse.wheel(0, -240);
    const isLarger = (old) => Number.parseFloat(document.getElementById('zoom').textContent) > old;
    if (enlarged < 96) await page.waitForFunction(isLarger, enlarged);
    assert.deepEqual(await place(page), before);
    assert.equal(await page.evaluate(() => window.scrollY), scroll);
    await press(page, '0');
    assert.equal(await zoomOf(page), fitting);
  },

  async 'dragging pans all views, a click sets the cursor, a double click fits'(page, {report}) {
    const fitting = await zoomOf(page);
    await enlarge(page, 'yours', 20);
    const size = await zoomOf(page);
    const box = await boxOf(page, 'reference');
    const point = {x: box.x + box.width / 2, y: box.y + box.height / 2};
    const room = (length, pixels) =>
        (pixels * size > length + 6 * size ? 2 * size : 0);  // what is seen whole stays in the middle
    const target = {x: point.x + room(box.width, report.width), y: point.y + room(box.height, report.height)};
    const before = await pixelUnder(page, point);
    await page.mouse.down();
    await page.mouse.move(point.x + 30, point.y + 40, {steps: 3});
    await page.mouse.move(target.x, target.y, {steps: 3});
    await page.mouse.up();
    assert.deepEqual(await pixelUnder(page, target), before);
    const clicked = await pixelUnder(page, point);
    await page.mouse.click(point.x, point.y);
    await page.mouse.move(1, 1);
    assert.deepEqual(await place(page), clicked);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'views');
    await page.mouse.dblclick(point.x, point.y);
    assert.equal(await zoomOf(page), fitting);
  },

  async 'two fingers zoom'(page) {
    const fitting = await zoomOf(page);
    const box = await boxOf(page, 'yours');
    const session = await page.context().newCDPSession(page);
    const touch = (type, half) => session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: half === null ?
          [] :
          [-half, half].map((dx, id) => ({x: box.x + box.width / 2 + dx, y: box.y + box.height / 2, id}))
    });
    await touch('touchStart', 30);
    for (const half of [40, 50, 60, 75, 90]) await touch('touchMove', half);
    await touch('touchEnd', null);
    const zoomed = await zoomOf(page);
    assert(zoomed > 1.5 * fitting || fitting >= 96 || zoomed === 96, `${zoomed} > ${fitting}`);
    await session.detach();
  },

  async 'keys choose what is seen'(page) {
    const visible = async () =>
        (await page.locator('figure:visible').evaluateAll((figures) => figures.map(({id}) => id.replace('view-', ''))))
            .join();
    for (const [key, expected] of [
             ['2', 'yours'], ['3', 'reference'], ['4', 'difference'], ['1', 'yours,reference,difference'], ['s', 'swipe'],
             ['s', 'yours,reference,difference'], ['b', 'blink'], ['b', 'yours,reference,difference']]) {
      await press(page, key);
      assert.equal(await visible(), expected, key);
    }
  },

  async 'swipe: a divider that is a slider, for the pointer and the keyboard'(page, data) {
    await press(page, 's');
    await withPlainViews(page, data);
    const divider = page.getByRole('slider', {name: 'Divider'});
    await divider.focus();
    await press(page, 'ArrowRight', 'ArrowRight');
    assert.equal(await divider.inputValue(), '51');
    await press(page, 'Home');
    assert.equal(await divider.inputValue(), '0');
    await enlarge(page, 'swipe', 24);
    assertColors(data, 'reference', await sample(page, data, 'swipe', spots));
    await divider.focus();
    await press(page, 'End');
    assertColors(data, 'yours', await sample(page, data, 'swipe', spots));
    const box = await boxOf(page, 'swipe');
    await page.mouse.move(box.x + box.width - 12, box.y + box.height * 0.3);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.3, {steps: 4});
    await page.mouse.up();
    assert(Math.abs(Number(await divider.inputValue()) - 50) < 2, await divider.inputValue());
    assertColors(data, 'yours', await sample(page, data, 'swipe', [[0.3, 0.5], [0.32, 0.7]]));
    assertColors(data, 'reference', await sample(page, data, 'swipe', [[0.67, 0.5], [0.7, 0.3]]));
  },

  async 'blink: off at first, at most twice a second, and stops'(page) {
    assert(!await page.isChecked('#mode-blink'));
    await press(page, 'b');
    const times = await page.evaluate(
        () => new Promise((done) => {
          const changes = [];
          const label = document.querySelector('#view-blink .side');
          new MutationObserver(() => changes.push([performance.now(), label.textContent])).observe(label, {childList: true});
          setTimeout(() => done(changes), 2300);
        }));
    assert(times.length >= 3 && times.length <= 5, `${times.length} changes`);
    assert.deepEqual(new Set(times.map(([, label]) => label)), new Set(['Yours', 'Reference']));
    await press(page, 'b');
    assert(await page.isChecked('#mode-side'));
  },

  async 'blink: not with reduced motion, and it says why'(page) {
    await press(page, 'b');
    assert(await page.isChecked('#mode-blink'));
    await page.emulateMedia({reducedMotion: 'reduce'});
    await page.waitForFunction(() => document.getElementById('mode-side').checked);
    assert(await page.isDisabled('#mode-blink'));
    assert.match(await text(page, '#blink-reason'), /reduced motion/);
    await press(page, 'b');
    assert(await page.isChecked('#mode-side'));
    await page.waitForFunction(() => /reduced motion/.test(document.getElementById('said').textContent));
    await page.emulateMedia({reducedMotion: 'no-preference'});
    await page.waitForFunction(() => !document.getElementById('mode-blink').disabled);
    assert(!await page.isVisible('#blink-reason'));
  },

  async 'the table of worst pixels leads there, by a click and by Enter'(page, {report: {comparison}}) {
    const rows = page.locator('#worst tr');
    assert.equal(await rows.count(), comparison.worst.length);
    assert.equal(await page.isVisible('#no-worst'), comparison.worst.length === 0);
    for (const [k, {column, row, image, least, greatest, distance}] of comparison.worst.entries()) {
      const cells = await rows.nth(k).locator('td').evaluateAll(
          (all) =>
              all.map((cell) => [...cell.querySelectorAll('span:not(.unseen)')].map((span) => span.textContent.slice(1))));
      assertNumbers(cells[1], image.map(Number), 'yours');
      assertNumbers(cells[2].map((range) => range.split(' to ')[0]), least.map(Number), 'least');
      assertNumbers(cells[2].map((range) => range.split(' to ').at(-1)), greatest.map(Number), 'greatest');
      assertNumbers([await rows.nth(k).locator('td').last().textContent()], [Number(distance)], 'distance');
      if (k % 2 === 0)
        await rows.nth(k).locator('td').nth(1).click();
      else {
        await rows.nth(k).getByRole('button').focus();
        await press(page, 'Enter');
      }
      assert.deepEqual(await place(page), {column, row});
      assert.equal(await rows.nth(k).getAttribute('aria-current'), 'true');
    }
  },

  async 'n and p go around the worst pixels'(page, {report: {comparison: {worst}}}) {
    if (worst.length < 2) return;
    await showWorst(page, 0);
    await press(page, 'p');
    assert.deepEqual(await place(page), {column: worst.at(-1).column, row: worst.at(-1).row});
    await press(page, 'n', 'n');
    assert.deepEqual(await place(page), {column: worst[1].column, row: worst[1].row});
  },

  async 'marks are drawn in the difference, and go away'(page, {report: {comparison, height}}) {
    if (comparison.worst.length === 0 || height < 3) return;
    await showWorst(page, 0);
    await focusViews(page);
    await press(
        page, ...Array(2).fill(comparison.worst[0].row < 2 ? 'ArrowDown' : 'ArrowUp'));  // the cursor would cover a mark
    const picture = async (view) => {
      await drawn(page);
      return page.locator(`#view-${view} canvas`).evaluate((canvas) => canvas.toDataURL());
    };
    const [difference, yours] = [await picture('difference'), await picture('yours')];
    await press(page, 'm');
    assert(!await page.isChecked('#marks'));
    assert(await picture('difference') !== difference, 'the difference has no marks');
    assert(await picture('yours') === yours, 'your image has marks');
  },

  async 'screen readers hear the cursor, politely and once for many steps'(page, data) {
    assert.equal(await page.getByRole('status').getAttribute('id'), 'said');
    await page.evaluate(() => {
      window.heard = 0;
      new MutationObserver(() => {
        ++window.heard;
      }).observe(document.getElementById('said'), {childList: true});
    });
    await focusViews(page);
    await press(page, ...Array(8).fill('ArrowRight'), ...Array(8).fill('ArrowLeft'), 'ArrowDown');
    await page.waitForTimeout(700);
    const {column, row} = await place(page);
    assert(await page.evaluate(() => window.heard) <= 2);
    assert((await page.locator('#said').textContent()).startsWith(`Column ${column}, row ${row}.`));
    const box = await boxOf(page, 'yours');
    await page.mouse.move(box.x + 9, box.y + 9, {steps: 20});
    const heard = await page.evaluate(() => window.heard);
    await page.waitForTimeout(600);
    assert.equal(await page.evaluate(() => window.heard), heard, 'the pointer is silent');
    await reset(page);
    await assertPanel(page, data);
  },

  async '? lists the keys in a dialog that keeps the focus; Esc closes it'(page) {
    await page.focus('#fit');
    await press(page, '?');
    const dialog = page.getByRole('dialog', {name: 'Keys'});
    assert(await dialog.isVisible());
    const before = await place(page);
    for (let k = 0; k < 5; ++k) {
      assert(
          await page.evaluate(
              () => document.getElementById('keys').contains(document.activeElement) ||
                  document.activeElement === document.body),
          'focus left');
      await press(page, 'Tab');
    }
    await press(page, 'n', '4');
    assert.deepEqual(await place(page), before);
    await press(page, 'Escape');
    assert(!await dialog.isVisible());
    assert.equal(await page.evaluate(() => document.activeElement.id), 'fit');
  },

  async 'keys can be kept to the views'(page) {
    await press(page, '?');
    await page.uncheck('#keys-everywhere');
    await page.click('#close-keys');
    await page.focus('#fit');
    await press(page, '4');
    assert(await page.isChecked('#mode-side'));
    await focusViews(page);
    await press(page, '4');
    assert(await page.isChecked('#mode-difference'));
    await press(page, '?');
    await page.check('#keys-everywhere');
    await press(page, 'Escape');
  },

  async 'Tab reaches every control, and the focus is seen'(page, {report: {comparison}}) {
    const expected =
        await page.locator('a[href], button:visible, input:not(:disabled):visible, [tabindex="0"]:visible')
            .evaluateAll(
                (all) => all.filter((element) => (element.type !== 'radio' || element.checked) && !element.closest('dialog'))
                             .length);
    const seen = new Set();
    for (let k = 0; k < expected + 1; ++k) {
      await press(page, 'Tab');
      const [name, outlined] = await page.evaluate(() => {
        const element = document.activeElement;
        const ringed = element.type === 'radio' ? element.nextElementSibling : element;
        if (element === document.body) return ['', true];  // after the last control
        return [element.id || element.className || element.textContent, getComputedStyle(ringed).outlineStyle !== 'none'];
      });
      assert(outlined, `${name} shows no focus`);
      if (name) seen.add(name);
    }
    for (const id
             of ['skip', 'mode-side', 'zoom-out', 'zoom-in', 'fit', 'exposure', 'exposure-reset', 'marks', 'show-keys',
                 'views', ...(comparison.worst.length ? ['previous-worst', 'next-worst', 'worst-table'] : [])])
      assert(seen.has(id), `${id} not in ${[...seen]}`);
    assert.equal(seen.size, expected);
  },

  async 'it has landmarks and headings'(page) {
    for (const role of ['banner', 'main', 'contentinfo', 'application'])
      assert.equal(await page.getByRole(role).count(), 1, role);
    assert.equal(await page.getByRole('heading', {level: 1}).count(), 1);
    assert.equal(await page.getByRole('heading', {level: 2}).count(), 3);
  },

  async 'nothing is wider than the window, from 320 pixels to 3840'(page) {
    for (const [width, height] of [[320, 640], [390, 844], [768, 1024], [1024, 768], [1440, 900], [3840, 2160]]) {
      await page.setViewportSize({width, height});
      for (const mode of ['1', '4', 's']) {
        if (mode === 's')
          await page.check('#mode-swipe', {force: true});
        else
          await press(page, mode);
        await drawn(page);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        assert(wide <= 0, `${width}: ${wide} too wide in mode ${mode}`);
      }
      await press(page, '1');
      const tops =
          await page.locator('figure:visible')
              .evaluateAll(
                  (figures) => new Set(figures.map((figure) => Math.round(figure.getBoundingClientRect().top))).size);
      assert.equal(tops, width < 768 ? 3 : 1, `${width}: views side by side or stacked`);
    }
  },

  async 'it prints light, without controls'(page) {
    await page.emulateMedia({media: 'print', colorScheme: 'dark'});
    assert(!await page.isVisible('.toolbar') && await page.isVisible('#view-difference') && await page.isVisible('#stats'));
    const [red] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert(red > 200);
  },

  async 'axe finds nothing, in all modes and colors'(page) {
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({colorScheme});
      for (const mode of ['1', '2', '3', '4', 's', 'b', '?']) {
        await press(page, '1', mode);
        await drawn(page);
        await assertNoAxeViolations(page, `${colorScheme}, key ${mode}`);
      }
      await press(page, 'Escape', '1', 'n');
      await page.setViewportSize({width: 320, height: 640});
      await assertNoAxeViolations(page, `${colorScheme}, narrow`);
      await page.setViewportSize(largeWindow);
    }
    await page.emulateMedia({contrast: 'more', reducedMotion: 'reduce'});
    await assertNoAxeViolations(page, 'more contrast, reduced motion');
  },
};

await testPages({readPage, reset, tests});
