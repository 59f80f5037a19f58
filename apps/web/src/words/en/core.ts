import { english, type Said } from '../said'

// What the core and the server say is English already; what they name by options stands elsewhere in the page.
const inThePage: [RegExp, string][] = [
  [/; give fit --drive-frequency if it is known, or choose a free part with --from and --to/, '; choose a free part with the handles'],
  [/ with --from and --to, or another --column/, ' with the handles, or another column'],
  [/ (with|by) --from( and --to)?/, ' with the handles'],
  [/give the samples per second with --rate, or name the column with --time-column/, 'give the samples per second'],
  [/, or name another column with --time-column/, ''],
  [/say which with --column, for instance --column ("[^"]*")/, 'choose one, for instance $1'],
  [/; --column names another/, '; another one can be chosen'],
  [/a fit needs --column/, 'a fit needs one to be chosen'],
]

export const core = (said: Said): string =>
  inThePage.reduce((text, [option, page]) => text.replace(option, page), english(said))
