// ------------------------------------------------------------------------------------------------------ about this run

const header = report.header ?? {};

function duration(value) {
  if (!isNumber(value)) return null;
  const whole = Math.round(value);
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${whole % 60} s`;
}

function dateText() {
  const date = new Date(header.date ?? NaN);
  if (Number.isNaN(date.getTime())) return header.date ?? null;
  return `${date.toLocaleString('en', {dateStyle: 'long', timeStyle: 'short', timeZone: 'UTC', hourCycle: 'h23'})} UTC`;
}

function commitText() {
  if (!header.commit) return header.version ? `version ${header.version}` : null;
  return `commit ${header.commit}${header.modified ? ', with changes that are not committed' : ''}`;
}

function showTop() {
  const cores = isNumber(header.cores) ? counted(header.cores, 'core') : null;
  const mode = header.mode ? `${header.mode} run${isNumber(header.seconds) ? ` of ${duration(header.seconds)}` : ''}` : null;
  const machine = [header.processor, cores].filter(Boolean).join(', ');
  byId('machine').textContent =
      [machine, dateText(), commitText(), mode].filter(Boolean).join(' · ') || 'The run\'s header is missing.';
  document.title = ['raylab bench', header.processor, header.date?.slice(0, 10)].filter(Boolean).join(', ');
  showNoise();
}

/** Above this share of noisy timings a run is to be done again before anyone relies on it. */
const noisyShare = 0.1;

function showNoise() {
  const timings = allTimings();
  const noisy = timings.filter(({timing}) => timing.noisy).length;
  if (noisy === 0) return;
  const isWarning = noisy > noisyShare * timings.length;
  byId('noise').hidden = false;
  byId('noise').classList.toggle('warning', isWarning);
  const sign = make('b', {textContent: isWarning ? '⚠ Noisy run. ' : 'Noise. '});
  const words = report.noise?.sentence ?? `${count(noisy)} of ${count(timings.length)} times have quartiles far apart.`;
  byId('noise').append(sign, `${words} `, make('a', {href: '#noisy', textContent: 'Which ones'}));
}

/** Every timing in the report, with the path to it in words. */
function* timingsIn(value, path) {
  if (value === null || typeof value !== 'object') return;
  if (isNumber(value.median) && typeof value.noisy === 'boolean') return yield {path, timing: value};
  const own = value.id ?? value.scene ?? value.name ?? value.family ?? value.title ?? value.feature ?? value.aa;
  const by = value.by ? `${value.by} ${value.precision}` : own;
  const point = isNumber(value.x) ? count(value.x) : by;
  const words = typeof point === 'string' ? [...path, point] : path;
  for (const [name, part] of Object.entries(value))
    yield* timingsIn(part, Array.isArray(value) || Array.isArray(part) ? words : [...words, name]);
}

const allTimings = () => ['images', 'kernels', 'growth'].flatMap((name) => [...timingsIn(report[name], [name])]);

function noisyPart() {
  const timings = allTimings();
  const noisy = timings.filter(({timing}) => timing.noisy);
  const title = make('h3', {id: 'noisy', textContent: 'Where it was noisy'});
  if (timings.length === 0) return make('div', {className: 'panel'}, title, notMeasured());
  if (noisy.length === 0) return make('div', {className: 'panel'}, title, make('p', {textContent: 'No timing was noisy.'}));
  const width = ({timing: {low, high, median: middle}}) => (high - low) / middle;
  const columns = [
    ['timing', ({path}) => path.join(', ').replaceAll('_', ' ')], ['median', ({timing}) => digits(timing.median), true],
    ['quartiles', ({timing}) => `${digits(timing.low)} to ${digits(timing.high)}`, true],
    ['apart', (entry) => `${digits(100 * width(entry), 2)} %`, true], ['rounds', ({timing}) => count(timing.rounds), true]
  ];
  noisy.sort((a, b) => width(b) - width(a));
  return make(
      'div', {className: 'panel'}, title,
      make('p', {textContent: 'Timings whose quartiles are more than a tenth of the median apart; marked ~ in the tables.'}),
      make(
          'details', {open: noisy.length <= 12}, make('summary', {textContent: counted(noisy.length, 'noisy timing')}),
          table('noisy timings', columns, noisy)));
}

function headerPart() {
  const peak = header.fma_peak_gflops;
  const rows = [
    ['Date', dateText()], ['Version', header.version], ['Commit', header.commit && commitText().replace('commit ', '')],
    ['Mode', header.mode], ['Took', duration(header.seconds)], ['Processor', header.processor],
    ['Cores', count(header.cores)], ['Memory', bytes(header.memory_bytes)], ['System', header.system],
    ['Compiler', header.compiler], ['Build', [header.build, header.flags].filter(Boolean).join(': ')],
    ['Instruction sets', list(header.simd).join(', ')],
    ['Scenes', list(header.scenes).map(({scene, sha1}) => `${scene} (sha1 ${sha1})`).join(', ')],
    ['Multiply-add peak', median(peak) !== null ? `${digits(peak.median)} Gflop/s (${spreadText(peak)})` : null]
  ].filter(([, text]) => text && text !== '–');
  const body = make(
      'tbody', {},
      ...rows.map(
          ([name, text]) => make('tr', {}, make('th', {scope: 'row', textContent: name}), make('td', {textContent: text}))));
  return make(
      'div', {className: 'panel'}, make('h3', {textContent: 'Machine and build'}),
      rows.length ? make('table', {className: 'facts'}, body) : notMeasured());
}

function commandPart() {
  const images = report.images ?? {};
  const size = (pair) => (list(pair).length === 2 ? `${pair[0]} × ${pair[1]} pixels` : null);
  const sizes = (name) => new Set(list(images.scenes).map((scene) => size(scene?.[name])).filter(Boolean));
  const timed = sizes('timed_size'), judged = sizes('error_size');
  const text = [
    timed.size && `Images are timed at ${[...timed].join(' or ')}`,
    judged.size && `arithmetic is judged at ${[...judged].join(' or ')}`,
    size(images.sampling_size) && `sampling at ${size(images.sampling_size)}`
  ].filter(Boolean).join(', ');
  return make(
      'div', {className: 'panel'}, make('h3', {textContent: 'To do it again'}),
      make('pre', {className: 'command', tabIndex: 0, textContent: header.command ?? 'raylab bench --out report'}),
      text ? make('p', {textContent: `${text}.`}) : null);
}

const terms = [
  ['Mpixel/s', 'Millions of pixels of the image a second, on one core.'],
  [
    'quartiles, rounds',
    'Each contender is timed once a round, in turn with the others. Half of the rounds lie between the quartiles.'
  ],
  [
    'rmse',
    'Root of the mean, over all pixels and components, of the squared difference from the reference. Colors run from 0 to 1.'
  ],
  ['PSNR', 'The rmse on a scale of decibels: -20 log10(rmse).'],
  ['flipped', 'Pixels with a component off by more than 2/255: a decision, such as hit or miss, fell the other way.'],
  ['rest', 'Of the pixels that are not flipped.'], ['front', 'What no other variant beats in both speed and error.'],
  ['f32, f64', 'Numbers of 32 and of 64 bits: single and double precision.'],
  [
    'textbook, solution, fast',
    'The formulas as textbooks print them; the lab\'s solution; the engine that traces many rays at once.'
  ],
  ['stages', 'The renderer made of the lab\'s tasks, with the solution in them.'],
  ['ulp', 'The distance between neighboring numbers of the precision, at the right answer.'],
  ['condition', 'How many times an input\'s relative rounding grows in the answer, whatever the formula.'],
  ['wrong decisions', 'Answers of the other kind, such as a hit in place of a miss.'],
  [
    'unexplained',
    'The largest of the errors in ulps over the condition: what the formula adds to what any formula must have.'
  ],
  ['exponent', 'The slope of the logarithm of the time over that of the count: 1 if the time is proportional to it.']
];

function termsPart() {
  const entries = terms.flatMap(([name, text]) => [make('dt', {textContent: name}), make('dd', {textContent: text})]);
  return make(
      'div', {className: 'panel'}, make('h3', {textContent: 'What the columns mean'}),
      make('dl', {className: 'terms'}, ...entries));
}

function showRun() {
  byId('run-body').append(make('div', {className: 'panels'}, commandPart(), headerPart(), termsPart(), noisyPart()));
}

showTop();
showChoices();
showImages();
showKernels();
showGrowth();
showEdges();
showRun();
