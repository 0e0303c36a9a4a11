// A special point as its orbit's panel, the pointer and the tables name it.
import { bareTitle, specialLook } from './marks.js';

// "PD1: period doubling, (1,1)"
export function specialTitle(view, { id, label, branch }) {
  const of = view.branches.find((known) => known.id === branch);
  return `${id}: ${bareTitle(specialLook(view.looks, label))}${of ? `, ${of.name}` : ''}`;
}
