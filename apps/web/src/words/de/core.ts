import type { Said } from '../said'

// What the program names by options stands elsewhere in the page.
const inThePage: [RegExp, string][] = [
  [/ mit --from und --to| mit --from/, ' mit den Griffen'],
  [/ oder mit --column eine andere Spalte/, ' oder eine andere Spalte'],
]

export const core = (said: Said): string =>
  typeof said === 'string' ? said : inThePage.reduce((text, [option, page]) => text.replace(option, page), said.de)
