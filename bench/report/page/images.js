// ------------------------------------------------------------------------------------------------------- which to pick

/** Options in one line each. */
const optionsOf = (pick) => pick.split(/ (?=--)/).map((textContent) => make('span', {textContent}));

function choiceItem({need, bound, pick, sentence, hard_sentence: hardSentence}) {
  const part = (cap, ...content) => make('div', {}, make('p', {className: 'cap', textContent: cap}), ...content);
  const text = (textContent) => make('p', {textContent: textContent ?? '–'});
  return make(
      'li', {},
      part('If you need', make('h3', {textContent: need ?? ''}), make('p', {className: 'soft', textContent: bound ?? ''})),
      part('Pick', make('p', {className: 'picked'}, ...optionsOf(pick ?? 'nothing'))),
      part('Speed and error', text(sentence)), part('On hard scenes', text(hardSentence)));
}

function showChoices() {
  const choices = list(report.choices);
  byId('choices').append(choices.length ? make('ol', {className: 'choices'}, ...choices.map(choiceItem)) : notMeasured());
}

// -------------------------------------------------------------------------------------------------------- whole images

const speedOf = (entry) => median(entry.mpixels_per_second);

function speedLine({mpixels_per_second: timing}) {
  return `${digits(median(timing))} Mpixel/s${spreadText(timing) ? ` (${spreadText(timing)})` : ''}`;
}

const placeOf = ({mpixels_per_second: timing}) => ({x: median(timing), xLow: timing.low, xHigh: timing.high});

/** The formulas in which a variant of the fast engine departs from it. */
function changesOf({renderer, sphere, power}) {
  if (renderer !== 'fast') return [];
  return [sphere === 'textbook' && 'textbook sphere', power === 'cosine' && 'cosine power'].filter(Boolean);
}

/** A variant's name without its instruction set and its anti-aliasing. */
const familyOf = (variant) => [`${variant.renderer} ${variant.precision}`, ...changesOf(variant)].join(', ');

function nameOf(variant) {
  const {renderer, precision, simd} = variant;
  return [[renderer, precision, simd].filter(Boolean).join(' '), ...changesOf(variant)].join(', ');
}

function flippedText(error) {
  const {flipped, non_finite: nonFinite} = error ?? {};
  return [flipped > 0 && `${count(flipped)} flipped`, nonFinite > 0 && `${count(nonFinite)} not finite`]
      .filter(Boolean)
      .join(', ');
}

function arithmeticLines(variant) {
  const error = variant.arithmetic ?? {};
  return [
    `${nameOf(variant)}${variant.on_front ? ', on the front' : ''}`, speedLine(variant),
    `rmse ${digits(error.rmse_rest)}, largest ${digits(error.max_rest)}, without flipped pixels`,
    `rmse ${digits(error.rmse)}, largest ${digits(error.max)}, with them`,
    `${count(error.flipped)} of ${count(error.pixels)} pixels flipped, ${count(error.non_finite)} not finite`
  ];
}

/**
 * The variant of each family whose name is written out: on the front, or else the fastest. The others have their set's
 * name.
 */
function leadersOf(variants) {
  return distinct(variants.map(familyOf)).map((family) => {
    const members = variants.filter((variant) => familyOf(variant) === family).sort((a, b) => speedOf(b) - speedOf(a));
    return members.find(({on_front: onFront}) => onFront) ?? members[0];
  });
}

/** Only the engine as it is has its instruction sets named: four times as many names would hide the plot. */
function labelsOf(variant, isNamed) {
  const changes = changesOf(variant);
  if (!isNamed && variant.simd) return {label: changes.length ? '' : variant.simd};
  const flipped = flippedText(variant.arithmetic);
  const withFlipped = (name) => (flipped ? `${name} (${flipped})` : name);
  return {
    label: withFlipped(nameOf(variant)),
    short: withFlipped(changes.length > 1 ? 'textbook formulas' : changes[0] ?? nameOf(variant))
  };
}

/** The engine with formulas that are not its own is drawn small: it is there to be compared with. */
function lookOfVariant(variant) {
  const look = lookOf(variant.renderer, variant.precision);
  return changesOf(variant).length ? {...look, shape: 'diamond', radius: 4} : look;
}

/** More pixels than `raylab diff` allows fell the other way: what the rest of them has says little. */
function isAnotherPicture({arithmetic}) {
  const {flipped, non_finite: nonFinite, pixels} = arithmetic ?? {};
  return (flipped ?? 0) + (nonFinite ?? 0) > 0.001 * pixels;
}

/** A key to the looks of variants. */
function variantKey(variants) {
  const names = new Map(variants.map((variant) => {
    const name = `${variant.renderer} ${variant.precision}`;
    return [changesOf(variant).length ? `${name} with textbook formulas` : name, lookOfVariant(variant)];
  }));
  const entries = [...names].sort(([a], [b]) => a.localeCompare(b)).map(([name, look]) => [look, name]);
  const crossed = variants.find(isAnotherPicture);
  const words = 'crossed out: another picture, more than one pixel in a thousand flipped';
  return key(crossed ? [...entries, [{...lookOfVariant(crossed), crossed: true}, words]] : entries);
}

function arithmeticPoints(variants) {
  const leaders = new Set(leadersOf(variants));
  return variants.map((variant) => {
    const error = variant.arithmetic ?? {};
    const isLeader = leaders.has(variant);
    return {
      ...placeOf(variant),
      y: isNumber(error.rmse_judged) ? error.rmse_judged : null,
      look: {...lookOfVariant(variant), crossed: isAnotherPicture(variant)},
      lines: arithmeticLines(variant),
      ...labelsOf(variant, isLeader || variant.on_front),
      needed: isLeader && (variant.on_front || changesOf(variant).length === 0),
      onFront: Boolean(variant.on_front),
      family: familyOf(variant),
    };
  });
}

const speedColumns = [
  ['Mpixel/s', ({mpixels_per_second: timing}) => digits(median(timing)) + noisySign(timing), true],
  ['quartiles', ({mpixels_per_second: timing}) => `${digits(timing?.low)} to ${digits(timing?.high)}`, true],
  ['rounds', ({mpixels_per_second: timing}) => count(timing?.rounds), true],
];

function errorColumns(pick) {
  const column = (heading, name, text = digits) => [heading, (row) => text(pick(row)?.[name]), true];
  return [
    column('rmse', 'rmse'), column('largest', 'max'), column('PSNR, dB', 'psnr'), column('rmse, rest', 'rmse_rest'),
    column('largest, rest', 'max_rest'), column('flipped', 'flipped', count), column('not finite', 'non_finite', count),
    column('pixels', 'pixels', count)
  ];
}

const onFront = (row) => (row.on_front ? 'yes' : '');

function arithmeticTable(scene, variants) {
  const columns =
      [['variant', nameOf], ...speedColumns, ...errorColumns(({arithmetic}) => arithmetic), ['on front', onFront]];
  return table(`${scene.scene}, ${variants[0].aa}: arithmetic`, columns, variants);
}

/** Of every scene the fastest instruction set of each family: what one scene alone cannot say. */
function scenesTable(aa) {
  const rows = list(report.images?.scenes)
                   .flatMap(
                       (scene) => leadersOf(list(scene.variants).filter((variant) => variant.aa === aa))
                                      .map((variant) => ({...variant, scene})));
  const columns = [
    ['scene', ({scene}) => `${scene.scene}${scene.hard ? ' (hard)' : ''}`], ['variant', nameOf], ...speedColumns.slice(0, 1),
    ...errorColumns(({arithmetic}) => arithmetic)
        .filter(([name]) => ['rmse, rest', 'largest, rest', 'flipped', 'not finite'].includes(name))
  ];
  return table(`every scene, ${aa}`, columns, rows);
}

function arithmeticPanel(scene, aa) {
  const all = list(scene.variants).filter((variant) => variant.aa === aa);
  const measured = all.filter((variant) => speedOf(variant) > 0 && variant.arithmetic);
  if (measured.length === 0) return [notMeasured('Arithmetic')];
  const same = {
    true: 'All instruction sets give the same bits.',
    false: 'Instruction sets give different bits.'
  }[scene.same_bits] ??
      '';
  const oracle = isNumber(scene.oracle_mpixels_per_second) ?
      `The oracle, which computes the reference, does ${digits(scene.oracle_mpixels_per_second)} Mpixel/s.` :
      '';
  return [
    make('p', {
      textContent:
          'How far rounding carries colors from the oracle\'s, which asks for the same samples with many more digits. ' +
          'Pixels in which rounding turned a decision, such as hit or miss, are counted as flipped and not in the rmse, ' +
          'unless they are more than one in a thousand.'
    }),
    variantKey(measured),
    scatterPlot(
        `Speed against the error of arithmetic, ${scene.scene}, ${aa}`, arithmeticPoints(measured),
        {xTitle: 'Mpixel/s, faster →', yTitle: 'rmse', breaks: true}),
    make('p', {
      className: 'soft',
      textContent: `The thick line is the front, its points are named in bold: nothing is both faster and closer. ` +
          `Bars are the quartiles of the timings. A zigzag leaves out decades without a point. ${same} ${oracle}`
    }),
    folded('All numbers of this plot', arithmeticTable(scene, all)), folded('Every scene', scenesTable(aa))
  ];
}

const sampleText = ({aa, samples}) =>
    (aa === 'none' || !isNumber(samples) ? aa : `${aa}, ${counted(Number(samples.toPrecision(3)), 'sample')}`);

function samplingPoint(entry) {
  return {
    ...placeOf(entry),
    y: isNumber(entry.error?.rmse) ? entry.error.rmse : null,
    look: {shape: 'diamond', kind: 'other', solid: Boolean(entry.on_front)},
    lines: [
      `${sampleText(entry)}${entry.on_front ? ', on the front' : ''}`, speedLine(entry),
      `rmse ${digits(entry.error?.rmse)}, largest ${digits(entry.error?.max)}, PSNR ${digits(entry.error?.psnr)} dB`
    ],
    label: sampleText(entry),
    needed: true,
    onFront: Boolean(entry.on_front),
    family: entry.aa,
  };
}

function samplingPanel(scene) {
  const measured = list(scene.sampling).filter((entry) => speedOf(entry) > 0 && entry.error);
  if (measured.length === 0) return [notMeasured('Sampling')];
  const samples = report.images.converged_samples;
  const columns = [
    ['pattern', ({aa}) => aa], ['samples', (entry) => digits(entry.samples), true], ...speedColumns,
    ...errorColumns(({error}) => error).slice(0, 3), ['on front', onFront]
  ];
  return [
    make('p', {
      textContent: 'How far an image with few samples a pixel is from ' +
          (isNumber(samples) ? `one with ${count(samples)}.` : 'one with very many.')
    }),
    scatterPlot(
        `Speed against the error of sampling, ${scene.scene}`, measured.map(samplingPoint),
        {xTitle: 'Mpixel/s, faster →', yTitle: 'rmse'}),
    folded('All numbers of this plot', table(`${scene.scene}: sampling`, columns, list(scene.sampling)))
  ];
}

function modelPanel(scene) {
  const measured = list(scene.model).filter(({error}) => error);
  if (measured.length === 0) return [notMeasured('Model')];
  const rows =
      [...measured]
          .sort((a, b) => (b.error.rmse ?? Infinity) - (a.error.rmse ?? Infinity))
          .map(({variant, error}) => ({
                 name: variant,
                 value: error.rmse,
                 text: digits(error.rmse),
                 look: {shape: 'square', kind: 'other', solid: true},
                 lines: [variant, `rmse ${digits(error.rmse)}, largest ${digits(error.max)}, PSNR ${digits(error.psnr)} dB`]
               }));
  return [
    make('p', {
      textContent: 'How far the textbook\'s renderer in f64 gets from the oracle if its model departs from docs/model.md. ' +
          'What departs in nothing has its rounding alone.'
    }),
    rowPlot(`Error of other models, ${scene.scene}`, rows, {xTitle: 'rmse, worse →'}),
    folded(
        'All numbers of this plot',
        table(`${scene.scene}: model`, [['model', ({variant}) => variant], ...errorColumns(({error}) => error)], measured))
  ];
}

function chooser(title, options) {
  const select = make('select');
  select.append(...options.map(([value, textContent]) => make('option', {value, textContent})));
  return {select, label: make('label', {}, title, select)};
}

function showImages() {
  const scenes = list(report.images?.scenes);
  if (scenes.length === 0) return byId('images-body').append(notMeasured());
  const aas = distinct(scenes.flatMap((scene) => list(scene.variants).map(({aa}) => aa)));
  const ordered = [...scenes].sort((a, b) => Boolean(a.hard) - Boolean(b.hard));
  const scene = chooser('Scene', ordered.map(({scene: name, hard}) => [name, hard ? `${name} (hard)` : name]));
  const aa = chooser('Anti-aliasing', aas.map((name) => [name, name === 'none' ? 'none: one sample a pixel' : name]));
  scene.select.id = 'scene';
  aa.select.id = 'aa';
  if (aas.includes('none')) aa.select.value = 'none';
  const panel = (title, control = null) => {
    const body = make('div', {className: 'panels'});
    byId('images-body')
        .lastElementChild.append(make('div', {className: 'panel'}, make('h3', {textContent: title}), control, body));
    return body;
  };
  byId('images-body').append(make('div', {className: 'controls'}, scene.label), make('div', {className: 'panels'}));
  const arithmetic = panel('Arithmetic', aas.length > 1 ? make('div', {className: 'controls'}, aa.label) : null);
  const sampling = panel('Sampling'), model = panel('Model');
  const find = () => scenes.find(({scene: name}) => name === scene.select.value);
  const showArithmetic = () => arithmetic.replaceChildren(...arithmeticPanel(find(), aa.select.value));
  const show = () => {
    showArithmetic();
    sampling.replaceChildren(...samplingPanel(find()));
    model.replaceChildren(...modelPanel(find()));
  };
  scene.select.addEventListener('change', show);
  aa.select.addEventListener('change', showArithmetic);
  show();
}
