// What the pages of results have in common.

const inWords = (verdict) => verdict.replaceAll('_', ' ');
const number = (value) => String(Math.round(1000 * value) / 1000);
const ofMost = ({got, most}) => `${number(got)} of ${number(most)}`;
const sum = (points) => points.reduce((all, {got, most}) => ({got: all.got + got, most: all.most + most}), {got: 0, most: 0});

/** Text of a submission: it may be in any script, and must not reorder what stands around it. */
const bdi = (text) => make('bdi', {textContent: text});
const pill = (verdict) => {
  const element = make('span', {className: 'pill', textContent: inWords(verdict)});
  element.dataset.verdict = verdict;
  return element;
};
