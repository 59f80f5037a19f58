// Whether an answer with its uncertainty is right, and what it lacks where it is not.
import { numberOf } from '../look/numbers'
import type { Expected } from './questions'

/// `given`: a text, for the teacher to read.
export type Verdict = 'empty' | 'right' | 'tooSmall' | 'tooLarge' | 'notYet' | 'noUncertainty' | 'noNumber' | 'given'

export interface Checked {
  verdict: Verdict
  /// How far off, in the answer's own ±; null where the ± did not decide.
  off: number | null
  /// How far off, as a part of the right value.
  part: number
  /// Signed: above the truth or below it.
  above: boolean
  /// The slip of the key that the value looks like.
  slip: string
}

export const plain = (verdict: Verdict): Checked => ({ verdict, off: null, part: 0, above: false, slip: '' })

/// What a person types into one field: "1,408 ± 0,002 Hz" and "17.04(3) N/m" hold the ± too.
export function answerOf(text: string, unit: string): { value: string; uncertainty: string | null } {
  const all = text.trim()
  const bare = unit && all.endsWith(unit) ? all.slice(0, -unit.length).trim() : all
  const [value, uncertainty] = bare.replace(/^\((.*)\)$/, '$1').split(/\s*(?:±|\+\s*\/?\s*[-−])\s*/)
  if (value && uncertainty) return { value, uncertainty }
  const brackets = bare.match(/^(.*\d)\((\d+)\)$/)
  if (!brackets) return { value: bare, uncertainty: null }
  const places = brackets[1]!.replace(/[\s\u202f\u00a0]/g, '').split(/[.,]/)[1]?.length ?? 0
  return { value: brackets[1]!, uncertainty: (Number(brackets[2]) / 10 ** places).toFixed(places) }
}

/// Of an honest ±: what chance does to one answer in 370. Twice it would be held against one careful student in twenty.
export const chance = 3

/// Right: within the tolerance; or within three times the own ±, or so near that it is right whatever the ±. A value is not
/// held against a student for a ± that claims too much; the ± is.
export function check(value: string, uncertainty: string, expected: Expected): Checked {
  if (value.trim() === '') return plain('empty')
  const typed = numberOf(answerOf(value, expected.unit).value)
  const given = expected.unsigned ? Math.abs(typed) : typed
  if (!Number.isFinite(given)) return plain('noNumber')
  const error = given - expected.value
  const found = { part: Math.abs(error / expected.value), above: error > 0, off: null, slip: '' }
  const needed = expected.uncertainty
  if (Math.abs(error) <= expected.enough) return { ...found, verdict: 'right' }
  if (!needed) return { ...found, verdict: 'notYet', slip: slipOf(given, expected) }
  const own = numberOf(answerOf(uncertainty, expected.unit).value)
  if (!(own > 0)) return plain('noUncertainty')
  const off = Math.abs(error) / own
  if (Math.abs(error) > Math.max(chance * own, needed.within)) return { ...found, off, verdict: 'notYet', slip: slipOf(given, expected) }
  // An honest ± is hardly below half of the least possible one.
  return { ...found, off, verdict: own < needed.least / 2 ? 'tooSmall' : own > needed.most ? 'tooLarge' : 'right' }
}

/// The nearest slip within 3 % of the value.
function slipOf(given: number, expected: Expected): string {
  let best = { name: '', part: 0.03 }
  for (const slip of expected.slips) {
    const part = Math.abs(given - slip.value) / Math.abs(slip.value)
    if (part < best.part) best = { name: slip.name, part }
  }
  return best.name
}
