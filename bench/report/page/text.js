// ------------------------------------------------------------------------------ the report, and numbers put into words
// A report of a run that was cut short lacks sections and numbers: nothing here relies on any of them.

const byId = (id) => document.getElementById(id);
const report = JSON.parse(byId('report').textContent);
const list = (value) => (Array.isArray(value) ? value : []);
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
const sum = (numbers) => numbers.filter(isNumber).reduce((total, number) => total + number, 0);
const largest = (numbers) => (numbers.some(isNumber) ? Math.max(...numbers.filter(isNumber)) : null);
const distinct = (values) => [...new Set(values)];

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children.filter((child) => child !== null));
  return element;
}

const notMeasured = (what = '') =>
    make('p', {className: 'missing', textContent: what ? `${what}: not measured.` : 'Not measured.'});

/** A number as engineers write it: 0.0123, 41.3, 2.1e-7. */
function digits(value, significant = 3) {
  if (!isNumber(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 0.001 && size < 1e5)
    return Number(value.toPrecision(significant)).toLocaleString('en', {maximumFractionDigits: 6});
  const [mantissa, exponent] = value.toExponential(significant - 1).split('e');
  return `${Number(mantissa)}e${Number(exponent)}`;
}

const count = (value) => (isNumber(value) ? value.toLocaleString('en') : '–');
const counted = (value, noun) => `${count(value)} ${noun}${value === 1 ? '' : 's'}`;

function seconds(value) {
  if (!isNumber(value)) return '–';
  const [unit, name] = [[1, 's'], [1e-3, 'ms'], [1e-6, 'µs']].find(([size]) => Math.abs(value) >= size) ?? [1e-9, 'ns'];
  return `${digits(value / unit)} ${name}`;
}

function bytes(value) {
  if (!isNumber(value)) return '–';
  const [unit, name] = [[1e9, 'GB'], [1e6, 'MB'], [1e3, 'kB']].find(([size]) => value >= size) ?? [1, 'bytes'];
  return `${digits(value / unit)} ${name}`;
}

/** A timing's spread: how far it can be trusted. */
function spreadText(timing, format = digits) {
  if (!isNumber(timing?.low) || !isNumber(timing?.high)) return '';
  const rounds = isNumber(timing.rounds) ? `, ${counted(timing.rounds, 'round')}` : '';
  return `quartiles ${format(timing.low)} to ${format(timing.high)}${rounds}${timing.noisy ? ', noisy' : ''}`;
}

const median = (timing) => (isNumber(timing?.median) ? timing.median : null);
const noisySign = (timing) => (timing?.noisy ? ' ~' : '');

/** A table in a box that scrolls by itself. A column is [heading, row => text or node, is it a number]. */
function table(caption, columns, rows) {
  const cell = ([, text, numeric], row, k) => {
    const content = text(row);
    return make(k === 0 ? 'th' : 'td', {className: numeric ? 'right' : '', ...(k === 0 && {scope: 'row'})}, content ?? '–');
  };
  const heading = ([text, , numeric]) => make('th', {scope: 'col', className: numeric ? 'right' : '', textContent: text});
  return make(
      'div', {className: 'scroller', tabIndex: 0, role: 'region', ariaLabel: caption},
      make(
          'table', {className: 'wide'}, make('caption', {textContent: caption}),
          make('thead', {}, make('tr', {}, ...columns.map(heading))),
          make('tbody', {}, ...rows.map((row) => make('tr', {}, ...columns.map((column, k) => cell(column, row, k)))))));
}

const folded = (title, ...content) => make('details', {}, make('summary', {textContent: title}), ...content);
