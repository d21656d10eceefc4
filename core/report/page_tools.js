// What the scripts of pages have in common.

const byId = (id) => document.getElementById(id);
const clamp = (value, least, greatest) => Math.min(greatest, Math.max(least, value));
const counted = (count, noun) => `${count.toLocaleString('en')} ${noun}${count === 1 ? '' : 's'}`;

/** An element with properties and children; texts become text, never markup. */
function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

