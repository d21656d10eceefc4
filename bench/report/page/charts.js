// ------------------------------------------------------------------------------------------- the three kinds of plots

const edgeBand = 28;  // pixels: the strip beside a logarithmic axis of what has no place on it

/** An area for the drawing, with room for the vertical axis' numbers. */
function areaOf(width, height, right = 14) {
  const textRoom = width < 500 ? 44 : 56;
  return {left: textRoom, right: width - right, top: 34, bottom: height - 44, textRoom};
}

// --- points

function placePoint(point, area, xAxis, yAxis) {
  const {x, xLow, xHigh, y} = point;
  const at = {x: xAxis.at(x), y: y === null ? area.top + 11 : y === 0 ? area.bottom - 11 : yAxis.at(y)};
  const spread = xLow > 0 && isNumber(xHigh) ? [xAxis.at(xLow), xAxis.at(xHigh)] : null;
  return {...point, at, spread};
}

/**
 * Points {x, xLow, xHigh, y, look, lines, label, short, needed, onFront, family}: x to the right is better, y up is worse,
 * both on logarithmic axes. A `y` of 0 stands below the axis, null, which is not finite, above it. A family's points are
 * joined. Where there is little room, the `short` label stands for the label.
 */
function scatterPlot(label, points, {xTitle, yTitle, breaks = false}) {
  return picture(label, (width) => {
    const area = areaOf(width, width < 500 ? 420 : 460);
    const zeros = points.some(({y}) => y === 0), wild = points.some(({y}) => y === null);
    const xAxis = logAxis(
        points.flatMap(({x, xLow, xHigh}) => [x, xLow, xHigh]).filter(isNumber), area.left + 24, area.right - 24,
        {room: 40, isExact: true});
    const yAxis = logAxis(
        points.map(({y}) => y).filter(isNumber), area.bottom - (zeros ? edgeBand : 8), area.top + (wild ? edgeBand : 8),
        {room: 22, breaks});
    const placed = points.map((point) => placePoint(point, area, xAxis, yAxis));
    const content = [
      ...frame(area, xAxis, yAxis, xTitle, yTitle), ...edges(area, zeros, wild),
      write(area.right - 4, area.bottom - 8, 'better ↘', 'soft halo', 'end'), ...frontLine(area, placed),
      ...familyLines(placed), ...placed.flatMap(spreadBar), ...pointLabels(area, placed, width),
      ...placed.map(
          ({at, look, lines}) =>
              mark(at.x, at.y, lines, shape(look, at.x, at.y, look.radius), ...(look.crossed ? [cross(at.x, at.y)] : [])))
    ];
    return {height: area.bottom + 44, content};
  });
}

function edges(area, zeros, wild) {
  const edge =
      (y, textY, text) => [line(area.left, y, area.right, y, 'grid'), write(area.left - 6, textY, text, 'soft', 'end')];
  return [
    ...(zeros ? edge(area.bottom - edgeBand + 4, area.bottom - 6, '0') : []),
    ...(wild ? edge(area.top + edgeBand - 4, area.top + 15, 'NaN, ∞') : []),
  ];
}

/** The edge of what was measured: right of it and below there is nothing. */
function frontLine(area, placed) {
  const front = placed.filter(({onFront}) => onFront).sort((a, b) => a.at.x - b.at.x);
  if (front.length === 0) return [];
  const path = front.map(({at}) => `V${at.y}H${at.x}`).join('');
  return [draw('path', {class: 'front', d: `M${area.left} ${front[0].at.y}${path}V${area.top}`})];
}

function familyLines(placed) {
  return distinct(placed.map(({family}) => family)).map((family) => {
    const members = placed.filter((point) => point.family === family).sort((a, b) => a.at.x - b.at.x);
    const path = draw('path', {class: 'family', d: `M${members.map(({at}) => `${at.x} ${at.y}`).join('L')}`});
    return draw('g', {class: members[0].look.kind}, path);
  });
}

function spreadBar({at, spread, look}) {
  if (!spread) return [];
  const [low, high] = spread;
  return [draw(
      'path', {class: `spread ${look.kind}`, d: `M${low} ${at.y}H${high}M${low} ${at.y - 4}v8M${high} ${at.y - 4}v8`})];
}

function pointLabels(area, placed, width) {
  const narrow = width < 560;
  const obstacles = placed.flatMap(({at, spread}) => {
    const own = boxAround(at.x, at.y, 14, 14);
    return spread ? [own, {left: spread[0], right: spread[1], top: at.y - 4, bottom: at.y + 4}] : [own];
  });
  obstacles.push({left: area.right - 66, right: area.right, top: area.bottom - 24, bottom: area.bottom});
  const labels = placed
                     .map(
                         ({at, label, short, onFront, needed}) =>
                             ({...at, text: narrow ? short ?? label : label, bold: onFront, needed}))
                     .filter(({text}) => text);
  labels.sort((a, b) => 2 * (b.bold - a.bold) + b.needed - a.needed);
  return placeLabels(
      labels, obstacles, {left: area.left + 2, right: area.right + 10, top: area.top, bottom: area.bottom - 1});
}

// --- lines

const dashes = ['', '8 4', '2 4', '12 4 2 4', '4 3', '16 5', '2 2 8 2'];

/** Moves names beside the ends of curves apart, so that none covers another, and none leaves the area. */
function spreadNames(names, area) {
  const step = 17;
  names.sort((a, b) => a.y - b.y);
  let least = area.top + 4;
  for (const name of names) {
    name.at = Math.max(name.y, least);
    least = name.at + step;
  }
  let most = area.bottom;
  for (const name of names.toReversed()) {
    name.at = Math.min(name.at, most);
    most = name.at - step;
  }
}

function drawCurve({look, points}, k) {
  const d = `M${points.map(({at}) => `${at.x} ${at.y}`).join('L')}`;
  const marks = points.map(({at, lines}) => mark(at.x, at.y, lines, shape(look, at.x, at.y, 4)));
  return draw(
      'g', {class: look.kind}, draw('path', {class: 'line', 'stroke-dasharray': dashes[k % dashes.length], d}), ...marks);
}

/** Names right of the plot; of a curve that ends early, beside its end. */
function curveNames(curves, area) {
  const ends = curves.map(({name, points}) => ({name, ...points.at(-1).at}));
  const isEarly = ({x}) => x < area.right - 80;
  const late = ends.filter((end) => !isEarly(end));
  spreadNames(late, area);
  const written = late.flatMap(
      ({name, x, y, at}) =>
          [draw('path', {class: 'axis', d: `M${x + 7} ${y}L${area.right + 12} ${at}h4`}),
           write(area.right + 20, at + 4.5, name)]);
  const early = ends.filter(isEarly).map(({name, x, y}) => ({x, y, text: name, needed: true}));
  const obstacles = curves.flatMap(({points}) => points.map(({at}) => boxAround(at.x, at.y, 10, 10)));
  return [...written, ...placeLabels(early, obstacles, area)];
}

/**
 * Curves {name, short, look, points: [{x, y, lines}]}, with their names beside their ends: at the right if they reach it.
 * Where there is little room, the `short` name stands for the name.
 */
function linePlot(label, curves, {xTitle, yTitle, log}) {
  return picture(label, (width) => {
    const nameOfCurve = ({name, short}) => (width < 400 ? short ?? name : name);
    const nameRoom = Math.min(0.5 * width, 34 + Math.max(0, ...curves.map((curve) => textWidth(nameOfCurve(curve)))));
    const area = areaOf(width, 330, nameRoom);
    const values = (pick) => curves.flatMap(({points}) => points.flatMap(pick)).filter(isNumber);
    const axis = log ? logAxis : linearAxis;
    const xAxis = axis(values(({x}) => x), area.left + (log ? 10 : 0), area.right - 6, {room: 56, isExact: true});
    const yAxis = axis(values(({y}) => y), area.bottom - (log ? 6 : 0), area.top + 4, {room: 26});
    const placed =
        curves.filter(({points}) => points.length > 0)
            .map((curve) => ({
                   ...curve,
                   name: nameOfCurve(curve),
                   points: curve.points.map((point) => ({...point, at: {x: xAxis.at(point.x), y: yAxis.at(point.y)}}))
                 }));
    const content = [...frame(area, xAxis, yAxis, xTitle, yTitle), ...placed.map(drawCurve), ...curveNames(placed, area)];
    return {height: area.bottom + 44, content};
  });
}

// --- rows

/** The words of a text in lines no wider than so many pixels. */
function wrapped(text, width) {
  const lines = [];
  for (const word of text.split(' ')) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && textWidth(longer) <= width)
      lines[lines.length - 1] = longer;
    else
      lines.push(word);
  }
  return lines;
}

/**
 * Rows {name, value, low, high, text, lines}, one below the other: a dot on a logarithmic axis, or a bar from `base` on.
 * `value` 0 stands at the left edge.
 */
function rowPlot(label, rows, {xTitle, base = null}) {
  return picture(label, (width) => {
    const narrow = width < 560;
    const nameRoom = narrow ? 0 : Math.min(0.4 * width, 16 + Math.max(...rows.map(({name}) => textWidth(name))));
    const valueRoom = 8 + Math.max(...rows.map(({text}) => textWidth(text)));
    const [left, right] = [Math.max(nameRoom, 12), width - valueRoom - 12];
    const numbers = rows.flatMap(({value, low, high}) => [value, low, high]).filter(isNumber);
    const axis = base === null ? logAxis(numbers, left + 20, right, {room: 40, breaks: true}) :
                                 linearAxis(numbers, left + 14, right, {room: 44, least: base});
    const content = [];
    let y = 4;
    for (const row of rows) {
      const names = wrapped(row.name, narrow ? width : nameRoom - 12);
      const textTop = y + 14;
      const middle = narrow ? y + 17 * names.length + 12 : y + 17 * names.length / 2 + 1;
      content.push(
          ...names.map((text, k) => write(0, textTop + 17 * k, text, 'halo')),
          ...oneRow(row, middle, axis, left, right, base));
      y = narrow ? middle + 16 : y + 17 * names.length + 10;
    }
    const grid = axis.ticks.flatMap(({at, text}) => [line(at, 0, at, y, 'grid'), write(at, y + 17, text, 'soft', 'middle')]);
    grid.push(...axis.breaks.map((at) => breakAcross(at, y)));
    if (base !== null) grid.push(line(axis.at(base), 0, axis.at(base), y, 'axis'));
    grid.push(write(Math.max(right, textWidth(xTitle)), y + 37, xTitle, 'soft', 'end'));
    return {height: y + 42, content: [...grid, ...content]};
  });
}

function oneRow({value, low, high, text, lines, look}, y, axis, left, right, base) {
  if (!isNumber(value)) return [write(right + 10, y + 4.5, text)];
  if (base === null) {
    const x = value > 0 ? axis.at(value) : left;
    return [line(left, y, x, y, 'grid'), mark(x, y, lines, shape(look, x, y)), write(right + 10, y + 4.5, text)];
  }
  const [x, from] = [Math.max(left, axis.at(value)), axis.at(base)];
  const bar = draw(
      'rect',
      {class: `bar ${look.kind}`, x: Math.min(x, from), y: y - 6, width: Math.max(1, Math.abs(x - from)), height: 12});
  const spread = isNumber(low) && isNumber(high) ? [line(Math.max(left, axis.at(low)), y, axis.at(high), y, 'axis')] : [];
  return [mark(x, y, lines, bar), ...spread, write(right + 10, y + 4.5, text)];
}
