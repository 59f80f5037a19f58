// How a curve of each meaning is drawn. The colours themselves stand in tokens.css.

/** A method's name, or a meaning that is no method. */
export type Meaning = string

export interface CurveLook {
  line: string // colour of the line
  word: string // colour of its name
  dash: number[] // [px], empty: solid
  width: number // [px]
}

const families: Record<string, [hue: string, dash: number[]]> = {
  verlet: ['sky', [11, 4]],
  yoshida4: ['sky', [8, 3]],
  rk4: ['amber', [11, 4]],
  heun: ['amber', [3, 3]],
  'dormand-prince': ['amber', [8, 3, 2, 3]],
  'implicit-midpoint': ['implicit-euler', [8, 3]],
  newmark: ['implicit-euler', [3, 3]],
  'generalized-alpha': ['implicit-euler', [8, 3, 2, 3]],
  'gauss-legendre4': ['implicit-euler', [2, 2]],
}

/** The value of a token of tokens.css, such as "ink" or "grid". */
export function token(name: string): string {
  const theme = document.documentElement.dataset.theme ?? ''
  const key = `${theme} ${name}`
  const before = tokens.get(key)
  if (before !== undefined) return before
  const value = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim()
  if (theme) tokens.set(key, value)
  return value
}
/** What was asked before, theme by theme: an answer of the browser's makes it style the whole page first. */
const tokens = new Map<string, string>()

/** On a wall lines are wider than the enlarged page makes them. */
const wider = (look: CurveLook): CurveLook => (document.documentElement.dataset.projector ? { ...look, width: 1.4 * look.width } : look)

/** `exact`, `measured`, `fitted`, `model` (dashed grey), `drive` or a method's name. `road`: drawn as the exact solution is. */
export const lookOf = (meaning: Meaning, road = meaning === 'exact'): CurveLook => wider(plainLook(meaning, road))
function plainLook(meaning: Meaning, road: boolean): CurveLook {
  if (road) return { line: token('line-exact'), word: token('word-exact'), dash: [], width: 4 }
  if (meaning === 'measured' || meaning === 'other') return { line: token('ink'), word: token('ink'), dash: [], width: 1.5 }
  if (meaning === 'model') return { line: token('text3'), word: token('text3'), dash: [6, 4], width: 1.5 }
  const [hue, dash] = families[meaning] ?? [meaning, []]
  const width = meaning === 'fitted' ? 2 : 1.5
  return { line: token(`line-${hue}`), word: token(`word-${hue}`), dash, width }
}

/** CSS colours of a meaning, for words and swatches outside of plots. */
export function cssOf(meaning: Meaning, road = meaning === 'exact'): { line: string; word: string; dash: number[] } {
  if (meaning === 'measured' || meaning === 'other') return { line: 'var(--ink)', word: 'var(--ink)', dash: [] }
  if (meaning === 'model') return { line: 'var(--text3)', word: 'var(--text3)', dash: [6, 4] }
  const [hue, dash] = road ? ['exact', []] : (families[meaning] ?? [meaning, []])
  return { line: `var(--line-${hue})`, word: `var(--word-${hue})`, dash: dash as number[] }
}
