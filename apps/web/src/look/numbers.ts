// Numbers as people read them: true minus, no-break space before units, as many digits as asked for.
const minus = '\u2212'
export const space = '\u00a0'

/** A decimal text with the language's mark; exponents as ×10ⁿ. */
function dress(text: string, comma: boolean): string {
  const [mantissa, exponent] = text.split('e')
  let dressed = mantissa.replace('-', minus)
  if (comma) dressed = dressed.replace('.', ',')
  if (exponent === undefined) return dressed
  const raised = [...String(Number(exponent))].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)])).join('')
  return `${dressed}\u202f×\u202f10${raised}`
}

let comma = false
/** German texts write 0,5. Set once by the language. */
export function useComma(yes: boolean): void {
  comma = yes
}

/** `digits` significant ones: 0.025 with 3 is 0.0250. */
export function significant(value: number, digits: number): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? '–' : value > 0 ? '∞' : `${minus}∞`
  if (value === 0) return dress((0).toFixed(Math.max(0, digits - 1)), comma)
  const size = Math.floor(Math.log10(Math.abs(value)))
  if (size < -5 || size > 6) return dress(value.toExponential(Math.max(0, Math.min(digits, 3) - 1)), comma)
  const places = Math.max(0, digits - 1 - size)
  return dress(value.toFixed(Math.min(places, 12)), comma)
}

/** `places` behind the mark. */
export function fixed(value: number, places: number): string {
  if (!Number.isFinite(value) || Math.abs(value) >= 1e7) return significant(value, 3)
  return dress(value.toFixed(places), comma).replace(/^−(0([.,]0*)?)$/, '$1')
}

/** What a field shows: at least three digits, and all that were given, to seven. */
export function exactly(value: number): string {
  let digits = 3
  while (digits < 7 && Number(value.toPrecision(digits)) !== Number(value.toPrecision(7))) ++digits
  return significant(value, digits)
}

/** A part of one as "+0.15 %", signed; below 0.005 % only that it is. */
export function percent(part: number, digits = 2): string {
  const size = Math.abs(part * 100)
  if (size > 0 && size < 0.005) return `<${space}${fixed(0.01, 2)}${space}%`
  const text = size >= 0.01 && size < 10 ** (digits - 1) ? fixed(part * 100, size < 1 ? 2 : 1) : significant(part * 100, digits)
  return `${part > 0 ? '+' : ''}${text}${space}%`
}

/** 1234567 as 1 234 567, with narrow spaces. */
export const thousands = (count: number): string => String(count).replace(/\B(?=(\d{3})+$)/g, '\u202f')

export const withUnit = (text: string, unit: string): string => (unit ? `${text}${space}${unit}` : text)

/** Numbers of a sentence as they are printed: "-1.69e-06" is −1.69 × 10⁻⁶. What stands in quotation marks stays as typed. */
export const typeset = (sentence: string): string =>
  sentence
    .replace(/(?<![\w."„“.,-])-?\d+(?:[.,]\d+)?e[+-]?\d+(?!\w)/g, (number) => dress(number, false))
    .replace(/(?<=^|[ \u00a0(±])-(?=\d)/g, minus)

const plain = (text: string): string => text.replaceAll(minus, '-').trim()
const withPoints = (text: string): string => plain(text).replace(/(\d),(?=\d)/g, '$1.')
const inThousands = /(?<![\d.,])[1-9]\d{0,2}(,\d{3})+(?![\d,])/

/**
 * What a person typed as the core reads it: true minus and decimal commas ("217,6 ± 0,3 g" has two) become plain. In
 * English "2,500" is no decimal comma: it is left for the core to refuse.
 */
export function asTyped(text: string): string {
  return !comma && inThousands.test(text) ? plain(text) : withPoints(text)
}

/** A number as typed, a comma in it as the decimal one in either language; NaN where it is none. */
export function numberOf(text: string): number {
  const typed = withPoints(text).replace(/[\s\u202f\u00a0]/g, '')
  return typed === '' ? NaN : Number(typed)
}

export const near = (value: number, wanted: number, by: number): boolean => Math.abs(value - wanted) <= by
