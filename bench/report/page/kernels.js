// ------------------------------------------------------------------------------------------------------------- kernels

const precisions = ['f32', 'f64'];
const results = (family) => list(family?.results);
const resultOf = (family, by, precision) =>
    results(family).find((result) => result.by === by && result.precision === precision);

/** What a task of ours is judged by: the fast engine where it has the task, else the solution. */
const oursIn = (family, precision) => resultOf(family, 'fast', precision) ?? resultOf(family, 'solution', precision);

/** One axis for all strips, so that they compare: from a tenth of an ulp on. What is less is exact. */
const leastUlps = 0.1;
const ulpsGreatest = () =>
    largest(list(report.kernels)
                .flatMap((task) => list(task.families).flatMap((family) => results(family).map(({ulps}) => ulps?.max)))) ??
    10;

const hasWildUlps = () =>
    list(report.kernels)
        .some((task) => list(task.families).some((family) => results(family).some(({ulps}) => ulps && !isNumber(ulps.max))));

function ulpsAxis(width) {
  const axis = logAxis([leastUlps, Math.max(10, ulpsGreatest())], 20, width - (hasWildUlps() ? 36 : 8), {room: 44});
  return {...axis, place: (value) => (!isNumber(value) ? width - 8 : value < leastUlps ? 8 : axis.at(value))};
}

/** A strip's marks {look, value, lane}; a value of null is not finite. */
function strip(width, marks, lanes = 2) {
  const axis = ulpsAxis(width), height = 17 * lanes;
  const content = axis.ticks.map(({at}) => line(at, 0, at, height, 'grid'));
  content.push(line(8, 0, 8, height, 'axis'));
  for (const {look, value, lane} of marks) content.push(shape(look, axis.place(value), 8.5 + 17 * lane, 4.5));
  return draw('svg', {viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true'}, ...content);
}

function stripAxis(width) {
  const axis = ulpsAxis(width);
  const content = axis.ticks.map(({at, text}) => write(at, 14, text, 'soft', 'middle'));
  if (hasWildUlps()) content.push(write(width - 8, 14, 'NaN', 'soft', 'middle'));
  return draw('svg', {viewBox: `0 0 ${width} 18`, 'aria-hidden': 'true'}, write(8, 14, '0', 'soft', 'middle'), ...content);
}

const isHard = (family) => Boolean(family.hard);
const familiesOf = (task, hard) => list(task.families).filter((family) => isHard(family) === hard);

/** The greatest error in ulps over families, of who is asked for: undefined if nobody has one. */
function worstUlps(families, find) {
  const maxima = families.map(find).filter((result) => result?.ulps).map(({ulps}) => ulps.max);
  if (maxima.length === 0) return undefined;
  return maxima.some((value) => !isNumber(value)) ? null : Math.max(...maxima);
}

function worstMarks(families) {
  const bys = ['textbook', 'solution', 'fast'];
  return precisions.flatMap((precision, lane) => bys.flatMap((by) => {
    const value = worstUlps(families, (family) => resultOf(family, by, precision));
    return value === undefined ? [] : [{look: lookOf(by, precision), value, lane}];
  }));
}

function totals(task, find) {
  const found = list(task.families).map(find).filter(Boolean);
  return found.length ? sum(found.map(({wrong_decisions: wrong, non_finite: wild}) => (wrong ?? 0) + (wild ?? 0))) : null;
}

/** "textbook → ours", one line a precision. */
function pairs(className, cap, pairOf, text) {
  const lines = precisions.map((precision) => {
    const [textbook, ours] = pairOf(precision);
    const isWorse = isNumber(ours) && isNumber(textbook) && className === 'wrong' && ours > textbook;
    return make('span', {className: isWorse ? 'worse' : '', textContent: `${text(textbook)} → ${text(ours)}`});
  });
  return make('div', {className: `lanes text ${className}`}, make('span', {className: 'cap', textContent: cap}), ...lines);
}

function taskRow(task) {
  const ordinary = familiesOf(task, false)[0];
  const stripCell = () => make('div', {className: 'strip'}, make('div'));
  return make(
      'summary', {className: 'row'},
      make('div', {className: 'name'}, make('b', {textContent: `${task.task ?? ''} ${task.name ?? ''}`})),
      make('div', {className: 'lanes which'}, ...precisions.map((textContent) => make('span', {textContent}))), stripCell(),
      stripCell(),
      pairs(
          'wrong', 'Wrong, textbook → ours',
          (precision) =>
              [totals(task, (family) => resultOf(family, 'textbook', precision)),
               totals(task, (family) => oursIn(family, precision))],
          count),
      pairs(
          'ns', 'ns, textbook → ours',
          (precision) => [median(resultOf(ordinary, 'textbook', precision)?.ns), median(oursIn(ordinary, precision)?.ns)],
          digits));
}

/** The median and the greatest error of one result as a line on the strips' axis. */
function rangeStrip({by, precision, ulps}) {
  if (!ulps) return '–';
  const width = 192, axis = ulpsAxis(width), look = lookOf(by, precision);
  const [from, to] = [axis.place(ulps.median), axis.place(ulps.max)];
  return draw(
      'svg', {viewBox: `0 0 ${width} 16`, 'aria-hidden': 'true'}, ...axis.ticks.map(({at}) => line(at, 0, at, 16, 'grid')),
      draw('path', {class: `spread ${look.kind}`, d: `M${from} 8H${to}M${from} 4v8`}), shape(look, to, 8, 4));
}

const ulpsText = (ulps, which) => (ulps ? (isNumber(ulps[which]) ? digits(ulps[which]) : 'not finite') : '–');

function familyPart(task, family) {
  const facts = [
    `${counted(family.inputs, 'input')}`,
    family.condition && `condition ${digits(family.condition.median)} in the median, ${digits(family.condition.max)} at most`
  ].filter(Boolean).join('; ');
  const columns = [
    ['by', ({by, precision}) => `${by} ${precision}`], ['ns', ({ns}) => digits(median(ns)) + noisySign(ns), true],
    ['ulps, median to most', rangeStrip], ['median', ({ulps}) => ulpsText(ulps, 'median'), true],
    ['most', ({ulps}) => ulpsText(ulps, 'max'), true], ['wrong decisions', ({wrong_decisions: wrong}) => count(wrong), true],
    ['not finite', ({non_finite: wild}) => count(wild), true], ['of answers', ({answers}) => count(answers), true],
    ['unexplained', ({unexplained}) => digits(unexplained), true]
  ];
  const title = make(
      'h3', {}, `${family.family ?? ''} `, isHard(family) ? make('span', {className: 'hard', textContent: '◆ hard'}) : null);
  const numbers = results(family).length ? table(`${task.name}: ${family.family}`, columns, results(family)) : notMeasured();
  for (const cell of numbers.querySelectorAll('td:nth-child(3)')) cell.className = 'range';
  return make('div', {}, title, make('p', {textContent: `${family.text ?? ''} (${facts})`}), numbers);
}

function taskItem(task) {
  const families = list(task.families);
  const content = make('div', {className: 'families'}, make('p', {textContent: task.summary ?? ''}));
  const item = make('details', {}, taskRow(task), content);
  const fill = () =>
      content.append(...(families.length ? families.map((family) => familyPart(task, family)) : [notMeasured()]));
  item.addEventListener('toggle', fill, {once: true});
  return item;
}

const stripOnPaper = 130;

/** All strips are as wide as the first. */
function drawStrips(host, tasks, width) {
  for (const [k, item] of [...host.querySelectorAll('details')].entries())
    for (const [j, cell] of [...item.querySelectorAll('summary .strip > div')].entries()) {
      const marks = worstMarks(familiesOf(tasks[k], j === 1));
      const none = make('span', {className: 'soft', textContent: 'yes or no'});
      cell.replaceChildren(marks.length ? strip(width, marks) : none);
    }
  for (const cell of host.querySelectorAll('.head .strip > div')) cell.replaceChildren(stripAxis(width));
}

function stripHead() {
  const cell = (text) => make('div', {textContent: text});
  const axisCell = (text) => make('div', {className: 'strip'}, make('span', {textContent: text}), make('div'));
  return make(
      'div', {className: 'row head'}, cell('Task'), cell(''), axisCell('Largest ulps, ordinary'),
      axisCell('Largest ulps, hard'), cell('Wrong answers, textbook → ours'), cell('ns a call, textbook → ours'));
}

function showKernels() {
  const tasks = list(report.kernels);
  if (tasks.length === 0) return byId('kernels-body').append(notMeasured());
  const kinds = distinct(tasks.flatMap(
      (task) => list(task.families).flatMap((family) => results(family).map(({by, precision}) => `${by} ${precision}`))));
  const host = make('div', {className: 'panel tasks'}, stripHead(), ...tasks.map(taskItem));
  const legend = key(kinds.map((kind) => [lookOf(...kind.split(' ')), kind]));
  byId('kernels-body').append(legend, host);
  const column = host.querySelector('.head .strip > div');
  drawAtWidth(column, () => stripOnPaper, (width) => drawStrips(host, tasks, width));
}
