// ----------------------------------------------------------------------------------------------------- cost and growth

const curveLooks = ['circle', 'square', 'triangle', 'diamond'];

/** A renderer's look, or, if the name says none, another one for each curve. */
function lookOfCurve(name, k, all) {
  const look = lookOfName(name);
  const isAlone =
      all.filter((other) => lookOfName(other).kind === look.kind && lookOfName(other).solid === look.solid).length === 1;
  return look.kind === 'other' || !isAlone ? {...look, shape: curveLooks[k % curveLooks.length]} : look;
}

function growthPoint(series, name, {x, seconds: timing, prepare_seconds: prepare, bytes: size}) {
  const spread = spreadText(timing, seconds);
  const lines = [`${name}, ${count(x)} ${series.x ?? ''}`, `${seconds(median(timing))}${spread ? ` (${spread})` : ''}`];
  if (median(prepare) !== null) lines.push(`prepared in ${seconds(median(prepare))}`);
  if (isNumber(size)) lines.push(`${bytes(size)} of memory`);
  return {x, y: median(timing), lines};
}

/** How the time grows, in words. */
function exponentText({curves, x}) {
  const known = list(curves).filter(({exponent}) => isNumber(exponent));
  if (known.length === 0) return '';
  const parts = known.map(
      ({name, exponent}) => `${digits(10 ** exponent, 2)} times as long with ${name} (exponent ${digits(exponent, 2)})`);
  return `Ten times the ${x} take ${parts.join(', ')}.`;
}

/** What the last point of the curves says of memory and preparation. */
function atTheEnd({curves, x}) {
  const ends = list(curves).flatMap(({name, points}) => list(points).slice(-1).map((point) => ({name, ...point})));
  const told = ends.find((point) => isNumber(point.bytes) || median(point.prepare_seconds) !== null);
  if (!told) return '';
  const parts = [
    median(told.prepare_seconds) !== null && `is prepared in ${seconds(median(told.prepare_seconds))}`,
    isNumber(told.bytes) && `takes ${bytes(told.bytes)} of memory`
  ].filter(Boolean);
  return `With ${count(told.x)} ${x}, ${told.name} ${parts.join(' and ')}.`;
}

function seriesPanel(series) {
  const title = make('h3', {textContent: series.title ?? series.id});
  const isDrawable = ({x, seconds: timing}) =>
      isNumber(x) && isNumber(median(timing)) && (!series.log || (x > 0 && timing.median > 0));
  const measured = list(series.curves)
                       .map((curve) => ({...curve, points: list(curve.points).filter(isDrawable)}))
                       .filter(({points}) => points.length > 0);
  const text = make('p', {textContent: [series.text, exponentText(series), atTheEnd(series)].filter(Boolean).join(' ')});
  if (measured.length === 0) return make('div', {className: 'panel'}, title, text, notMeasured());
  const names = measured.map(({name}) => name);
  const curves = measured.map(
      ({name, points}, k) =>
          ({name, look: lookOfCurve(name, k, names), points: points.map((point) => growthPoint(series, name, point))}));
  const rows = measured.flatMap(({name, points}) => points.map((point) => ({name, ...point})));
  const columns = [
    ['curve', ({name}) => name], [series.x ?? 'x', ({x}) => count(x), true],
    ['time', ({seconds: timing}) => seconds(median(timing)) + noisySign(timing), true],
    ['quartiles', ({seconds: timing}) => `${seconds(timing.low)} to ${seconds(timing.high)}`, true],
    ['prepare', ({prepare_seconds: prepare}) => seconds(median(prepare)) + noisySign(prepare), true],
    ['memory', ({bytes: size}) => bytes(size), true]
  ];
  return make(
      'div', {className: 'panel'}, title, text,
      linePlot(`Time by ${series.x}`, curves, {xTitle: series.x ?? '', yTitle: 'seconds', log: Boolean(series.log)}),
      folded('All numbers of this plot', table(`${series.title}`, columns, rows)));
}

function featuresPanel(features) {
  const title = make('h3', {textContent: 'What each feature costs'});
  const text = make(
      'p', {textContent: 'The time of an image with the feature over that of the same image without it; 1 costs nothing.'});
  const ratio = (entry) => median(entry.with) / median(entry.without);
  const measured = features.filter((entry) => median(entry.with) !== null && median(entry.without) > 0);
  if (measured.length === 0) return make('div', {className: 'panel'}, title, notMeasured());
  const rows = [...measured]
                   .sort((a, b) => ratio(b) - ratio(a))
                   .map((entry) => ({
                          name: entry.feature,
                          value: ratio(entry),
                          text: `×${ratio(entry).toFixed(2)}`,
                          look: {kind: 'other'},
                          lines: [
                            `${entry.feature}: ×${ratio(entry).toFixed(3)}`,
                            `without ${seconds(entry.without.median)} (${spreadText(entry.without, seconds)})`,
                            `with ${seconds(entry.with.median)} (${spreadText(entry.with, seconds)})`, entry.text ?? ''
                          ].filter(Boolean)
                        }));
  const columns = [
    ['feature', ({feature}) => feature], ['without', ({without}) => seconds(median(without)) + noisySign(without), true],
    ['with', (entry) => seconds(median(entry.with)) + noisySign(entry.with), true],
    ['ratio', (entry) => digits(ratio(entry)), true], ['what was measured', ({text: what}) => what ?? '']
  ];
  return make(
      'div', {className: 'panel'}, title, text,
      rowPlot('Cost of features', rows, {xTitle: 'times as long with it', base: 1}),
      folded('All numbers of this plot', table('Cost of features', columns, features)));
}

function showGrowth() {
  const series = list(report.growth?.series), features = list(report.growth?.features);
  if (series.length + features.length === 0) return byId('growth-body').append(notMeasured());
  const panels = series.map(seriesPanel);
  if (features.length) panels.push(featuresPanel(features));
  byId('growth-body').append(make('div', {className: 'two'}, ...panels));
}

// --------------------------------------------------------------------------------------------------------------- edges

function showEdges() {
  const patterns = list(report.edges?.patterns).filter(({points}) => list(points).length > 0);
  if (report.edges?.sentence) byId('edges-body').append(make('p', {textContent: report.edges.sentence}));
  if (patterns.length === 0) return byId('edges-body').append(notMeasured());
  const curves =
      patterns.map((pattern, k) => ({
                     name: sampleText(pattern),
                     short: pattern.aa,
                     look: {
                       shape: curveLooks[k % curveLooks.length],
                       kind: ['fast', 'stages', 'textbook', 'other'][k % 4],
                       solid: (k + Math.floor(k / 4)) % 2 === 1
                     },
                     points: pattern.points.filter(({degrees, rmse}) => isNumber(degrees) && isNumber(rmse))
                                 .map(({degrees, rmse}) => ({
                                        x: degrees,
                                        y: rmse,
                                        lines: [`${sampleText(pattern)}, ${digits(degrees)}°`, `rmse ${digits(rmse)}`]
                                      }))
                   }));
  const degrees = distinct(patterns.flatMap(({points}) => points.map((point) => point.degrees))).sort((a, b) => a - b);
  const at = ({points}, angle) => points.find((point) => point.degrees === angle)?.rmse;
  const columns = [
    ['degrees', (angle) => digits(angle)],
    ...patterns.map((pattern) => [sampleText(pattern), (angle) => digits(at(pattern, angle)), true])
  ];
  byId('edges-body')
      .append(make(
          'div', {className: 'panel'},
          linePlot(
              'Error by the angle of an edge', curves,
              {xTitle: 'degrees of the edge', yTitle: 'rmse of the pixels on the edge', log: false}),
          folded('All numbers of this plot', table('rmse by angle', columns, degrees))));
}
