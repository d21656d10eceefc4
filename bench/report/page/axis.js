// ---------------------------------------------------------------------------------------------- from numbers to pixels

const leastGap = 3;    // decades without a value, from which on a logarithmic axis leaves them out
const breakSize = 26;  // pixels: what a left out part takes
const steps = [1, 2, 5];

function roundDown(value) {
  const decade = 10 ** Math.floor(Math.log10(value) + 1e-9);
  return decade * steps.findLast((step) => value / decade >= step - 1e-9);
}

function roundUp(value) {
  const decade = 10 ** Math.floor(Math.log10(value) - 1e-9);
  return decade * [...steps, 10].find((step) => value / decade <= step + 1e-9);
}

/** An exact end where the values are whole anyway; else there is a tick at or beyond it, and a decade at least. */
function onePiece({from, to}, isExact) {
  if (isExact && from < to) return {from: Math.log10(from), to: Math.log10(to)};
  const [low, high] = [Math.log10(roundDown(from / 1.1)), Math.log10(roundUp(to * 1.1))];
  return high - low < 1 ? {from: Math.floor(low), to: Math.max(Math.ceil(high), Math.floor(low) + 1)} :
                          {from: low, to: high};
}

/** The parts of a logarithmic axis, as exponents of ten: whole decades where the axis may break. */
function logPieces(values, breaks, isExact) {
  const pieces = [];
  for (const value of [...values].sort((a, b) => a - b)) {
    const last = pieces.at(-1);
    if (last && (!breaks || Math.log10(value / last.to) <= leastGap))
      last.to = value;
    else
      pieces.push({from: value, to: value});
  }
  if (pieces.length === 0) pieces.push({from: 1, to: 1});
  if (!breaks) return [onePiece(pieces[0], isExact)];
  return pieces.map(({from, to}) => ({from: Math.floor(Math.log10(from) - 0.08), to: Math.ceil(Math.log10(to) + 0.08)}));
}

function tickText(value) {
  return value >= 0.001 && value < 1e6 ? Number(value.toPrecision(3)).toLocaleString('en', {maximumFractionDigits: 3}) :
                                         value.toExponential(0).replace('+', '');
}

/** Ticks of one piece: as many as leave `room` pixels between two of them. */
function logTicks({from, to}, pixelsPerDecade, room) {
  const ticks = [];
  if (pixelsPerDecade * Math.log10(2) >= room) {
    for (let decade = Math.floor(from); decade <= to; ++decade)
      for (const step of steps) ticks.push(decade + Math.log10(step));
  } else {
    const every = Math.max(1, Math.ceil(room / pixelsPerDecade));
    for (let decade = Math.ceil(from - 1e-9); decade <= to + 1e-9; ++decade)
      if (decade % every === 0) ticks.push(decade);
  }
  return ticks.filter((tick) => tick >= from - 1e-9 && tick <= to + 1e-9);
}

/**
 * A logarithmic axis from the pixel `start` to the pixel `end`: {at: from a number to its pixel, ticks, breaks: pixels}.
 * With `breaks`, what lies between numbers far apart is left out; an `isExact` one ends at the least and the greatest.
 */
function logAxis(values, start, end, {room, breaks = false, isExact = false}) {
  const pieces = logPieces(values.filter((value) => value > 0), breaks, isExact);
  const way = Math.sign(end - start);
  const decades = pieces.reduce((total, piece) => total + piece.to - piece.from, 0);
  const pixelsPerDecade = (Math.abs(end - start) - breakSize * (pieces.length - 1)) / decades;
  let at = start;
  for (const piece of pieces) {
    piece.start = at;
    at += way * ((piece.to - piece.from) * pixelsPerDecade + breakSize);
  }
  const place = (exponent) => {
    const piece = pieces.findLast(({from}) => exponent >= from - 1e-9) ?? pieces[0];
    return piece.start + way * (exponent - piece.from) * pixelsPerDecade;
  };
  return {
    at: (value) => place(Math.log10(value)),
    ticks: pieces.flatMap((piece) => logTicks(piece, pixelsPerDecade, room))
               .map((tick) => ({at: place(tick), text: tickText(10 ** tick)})),
    breaks: pieces.slice(1).map((piece) => piece.start - way * breakSize / 2),
  };
}

/** A linear axis from `least` to at least the greatest of the values. */
function linearAxis(values, start, end, {room, least = 0}) {
  const greatest = Math.max(...values, least + 1e-12);
  const most = Math.max(2, Math.floor(Math.abs(end - start) / room));
  const step = roundUp((greatest - least) / most);
  const to = least + step * Math.ceil((greatest - least) / step - 1e-9);
  const at = (value) => start + (end - start) * (value - least) / (to - least);
  const ticks = [];
  for (let k = 0; least + k * step <= to * (1 + 1e-9); ++k)
    ticks.push({at: at(least + k * step), text: tickText0(least + k * step)});
  return {at, ticks, breaks: []};
}

const tickText0 = (value) => (Math.abs(value) < 1e-12 ? '0' : tickText(value));
