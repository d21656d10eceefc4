// --------------------------------------------------------------------------------------------- drawing, points and text

function draw(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const line = (x1, y1, x2, y2, className) => draw('line', {x1, y1, x2, y2, class: className});
const write = (x, y, text, className = '', anchor = 'start') =>
    draw('text', {x, y, class: className, 'text-anchor': anchor}, text);

const shapes = {
  circle: (r) => `M${- r} 0a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${- 2 * r} 0z`,
  square: (r) => `M${- 0.9 * r} ${- 0.9 * r}h${1.8 * r}v${1.8 * r}h${- 1.8 * r}z`,
  triangle: (r) => `M0 ${- 1.15 * r}L${1.1 * r} ${0.85 * r}H${- 1.1 * r}z`,
  diamond: (r) => `M0 ${- 1.25 * r}L${1.25 * r} 0L0 ${1.25 * r}L${- 1.25 * r} 0z`,
};

function shape({shape: name, solid, kind}, x, y, radius = 5.5) {
  return draw(
      'path', {d: shapes[name](radius), transform: `translate(${x} ${y})`, class: `shape ${kind} ${solid ? 'solid' : ''}`});
}

/** A cross over a point whose place is not to be relied on. */
const cross = (x, y) => draw('path', {class: 'cross', d: `M${x - 8} ${y - 8}l16 16m0 -16l-16 16`});

const looks = {
  fast: {shape: 'circle', kind: 'fast'},
  stages: {shape: 'square', kind: 'stages'},
  solution: {shape: 'square', kind: 'stages'},
  textbook: {shape: 'triangle', kind: 'textbook'},
};

/** How a renderer in a precision looks: the shape says which renderer, and it is filled for f64. */
const lookOf = (renderer, precision) =>
    ({...(looks[renderer] ?? {shape: 'diamond', kind: 'other'}), solid: precision === 'f64'});

/** The look of a curve by the words of its name, as far as they say one. */
function lookOfName(name) {
  const words = name.split(/\s+/);
  return lookOf(words.find((word) => word in looks), words.find((word) => word === 'f64'));
}

function key(entries) {
  return make('ul', {className: 'key'}, ...entries.map(([look, text]) => {
    const picture = draw(
        'svg', {viewBox: '0 0 16 16', 'aria-hidden': 'true'}, shape(look, 8, 8, 5),
        ...(look.crossed ? [cross(8, 8)] : []));
    return make('li', {}, picture, text);
  }));
}

const pen = document.createElement('canvas').getContext('2d');

function textWidth(text, bold = false, size = 13) {
  pen.font = `${bold ? '700' : '400'} ${size}px ${getComputedStyle(document.body).fontFamily}`;
  return pen.measureText(text).width;
}

// --- the numbers of a point, on hover and focus

const tip = byId('tip');
let shown = null;

function hideTip() {
  shown?.classList.remove('shown');
  shown = null;
  tip.hidden = true;
}

function showTip(mark) {
  if (mark === shown) return;
  hideTip();
  shown = mark;
  mark.classList.add('shown');
  const [name, ...facts] = mark.lines;
  tip.replaceChildren(make('b', {textContent: name}), ...facts.map((textContent) => make('span', {textContent})));
  tip.hidden = false;
  placeTip();
}

function placeTip() {
  const point = shown.querySelector('.ring').getBoundingClientRect();
  const box = tip.getBoundingClientRect();
  const left = point.left + point.width / 2 - box.width / 2;
  tip.style.left = `${Math.max(8, Math.min(left, document.documentElement.clientWidth - box.width - 8))}px`;
  tip.style.top = `${point.top - box.height - 6 > 0 ? point.top - box.height - 6 : point.bottom + 6}px`;
}

/** A point: what it looks like, where it is, and its numbers as lines of text, the first of which is its name. */
function mark(x, y, lines, ...pictures) {
  const group = draw(
      'g', {class: 'mark', role: 'img', 'aria-label': lines.join(', '), tabindex: -1}, ...pictures,
      draw('circle', {class: 'ring', cx: x, cy: y, r: 11}));
  group.lines = lines;
  group.place = {x, y};
  group.addEventListener('focus', () => showTip(group));
  group.addEventListener('blur', hideTip);
  return group;
}

const forward = ['ArrowRight', 'ArrowDown'], backward = ['ArrowLeft', 'ArrowUp'];

/**
 * A plot is one stop of the Tab key, and the arrow keys go from point to point, so that a page of many points stays short.
 */
function makeReachable(picture) {
  const marks = [...picture.querySelectorAll('.mark')];
  if (marks.length === 0) return;
  const enter = (next) => {
    for (const other of marks) other.setAttribute('tabindex', other === next ? 0 : -1);
  };
  enter(marks[0]);
  picture.addEventListener('keydown', (event) => {
    const at = marks.indexOf(document.activeElement);
    const way = forward.includes(event.key) - backward.includes(event.key);
    if (at < 0 || way === 0) return;
    const next = marks[(at + way + marks.length) % marks.length];
    enter(next);
    next.focus();
    event.preventDefault();
  });
  picture.addEventListener('pointermove', (event) => {
    const box = picture.getBoundingClientRect();
    const scale = picture.viewBox.baseVal.width / box.width;
    const [x, y] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    const away = ({place}) => Math.hypot(place.x - x, place.y - y);
    const nearest = marks.reduce((best, next) => (away(next) < away(best) ? next : best));
    if (away(nearest) < 24)
      showTip(nearest);
    else
      hideTip();
  });
  picture.addEventListener('pointerleave', hideTip);
}

/** Calls `redraw` with the width of an element whenever that changes, and with the width it has on paper before printing. */
function drawAtWidth(element, widthOnPaper, redraw) {
  let drawn = 0;
  const redrawFor = (width) => {
    if (width === drawn || width === 0) return;
    drawn = width;
    hideTip();
    redraw(width);
  };
  new ResizeObserver(() => redrawFor(element.clientWidth)).observe(element);
  window.addEventListener('beforeprint', () => element.isConnected && redrawFor(widthOnPaper(element)));
  window.addEventListener('afterprint', () => redrawFor(element.clientWidth));
}

/** In pixels of CSS: what an upright page of A4 or Letter has room for. */
const paperWidth = (host) => (host.closest('.two') && !host.closest('.panel:last-child:nth-child(odd)') ? 310 : 660);

/** Puts a picture into the page that is drawn for the width there is. */
function picture(label, drawFor) {
  const host = make('div', {className: 'plot'});
  drawAtWidth(host, paperWidth, (width) => {
    const {height, content} = drawFor(width);
    const drawing = draw('svg', {viewBox: `0 0 ${width} ${height}`, role: 'group', 'aria-label': label}, ...content);
    makeReachable(drawing);
    host.replaceChildren(drawing);
  });
  return host;
}

document.addEventListener('keydown', (event) => {
  if (event.key === 'Escape') hideTip();
});
document.addEventListener('scroll', () => {
  if (shown && shown === document.activeElement)
    placeTip();  // it may be the focus that scrolled
  else
    hideTip();
}, {passive: true, capture: true});

// --- labels beside points, none over another

const overlap = (a, b) => Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
const boxAround = (x, y, w, h) => ({left: x - w / 2, right: x + w / 2, top: y - h / 2, bottom: y + h / 2});
const directions = [[1, 0], [0, -1], [0, 1], [-1, 0], [1, -1], [1, 1], [-1, -1], [-1, 1]];
const distances = [10, 18, 30, 44, 60, 80];

function outside(box, area) {
  return Math.max(0, area.left - box.left) + Math.max(0, box.right - area.right) + Math.max(0, area.top - box.top) +
      Math.max(0, box.bottom - area.bottom);
}

/** Where a label goes: as near to its point as it can without covering anything. */
function bestPlace({x, y, width, height}, taken, area) {
  let best = null;
  for (const distance of distances)
    for (const [k, [dx, dy]] of directions.entries()) {
      const reach = dx && dy ? distance * 0.7 : distance;
      const beside = x + dx * (reach + width / 2);
      const inside = Math.max(area.left + width / 2, Math.min(beside, area.right - width / 2));
      const box = boxAround(dy ? inside : beside, y + dy * (reach + height / 2), width, height);
      const covered = taken.reduce((total, other) => total + overlap(box, other), 0);
      const cost = covered * 10 + outside(box, area) * 1000 + distance + k;
      if (!best || cost < best.cost) best = {cost, box, covered, isClear: covered === 0 && outside(box, area) === 0};
    }
  return best;
}

/** Labels {x, y, text, bold, needed}, the most important first. One that finds no free place is left out unless needed. */
function placeLabels(labels, obstacles, area) {
  const taken = [...obstacles];
  const drawn = [];
  for (const label of labels) {
    const width = textWidth(label.text, label.bold) + 4, height = 16;
    const {box, isClear} = bestPlace({...label, width, height}, taken, area);
    if (!isClear && !label.needed) continue;
    taken.push(box);
    const near = {x: Math.max(box.left, Math.min(label.x, box.right)), y: Math.max(box.top, Math.min(label.y, box.bottom))};
    const gap = Math.hypot(near.x - label.x, near.y - label.y);
    if (gap > 15) {
      const from = {x: label.x + (near.x - label.x) * 8 / gap, y: label.y + (near.y - label.y) * 8 / gap};
      drawn.push(line(from.x, from.y, near.x, near.y, 'leader'));
    }
    drawn.push(write(box.left + 2, box.bottom - 4, label.text, label.bold ? 'halo bold' : 'halo'));
  }
  return drawn;
}

// --- axes

/** Grid lines and numbers of a plot whose axes cross at the left and below. */
function frame(area, xAxis, yAxis, xTitle, yTitle) {
  const parts = [write(area.left - area.textRoom, area.top - 14, yTitle, 'soft')];
  for (const {at, text} of yAxis.ticks)
    parts.push(line(area.left, at, area.right, at, 'grid'), write(area.left - 6, at + 4.5, text, 'soft', 'end'));
  for (const {at, text} of xAxis.ticks)
    parts.push(line(at, area.top, at, area.bottom, 'grid'), write(at, area.bottom + 17, text, 'soft', 'middle'));
  parts.push(draw('path', {class: 'axis', d: `M${area.left} ${area.top}V${area.bottom}H${area.right}`}));
  for (const at of yAxis.breaks) parts.push(breakSign(area, at));
  parts.push(write(area.right, area.bottom + 36, xTitle, 'soft', 'end'));
  return parts;
}

function zigzag(length) {
  let path = '';
  for (let k = 0; 6 * k < length; ++k) path += `l6 ${k % 2 ? 4 : -4}`;
  return path;
}

/** Where a vertical axis leaves a part out: a zigzag across the plot, on which the axis has a gap. */
function breakSign({left, right}, y) {
  return draw(
      'g', {}, draw('rect', {x: left - 6, y: y - 5, width: right - left + 12, height: 6, class: 'gap'}),
      draw('path', {class: 'break', d: `M${left - 6} ${y}${zigzag(right - left + 6)}`}));
}

/** The same of a horizontal axis. */
const breakAcross = (x, height) =>
    draw('path', {class: 'break', d: `M0 0${zigzag(height)}`, transform: `translate(${x} 0) rotate(90)`});
