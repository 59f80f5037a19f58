// A value with its uncertainty as people write it: 17.04 ± 0.02 N/m.
import { fixed, space, withUnit } from '../look/numbers'

/// Digits behind the mark at which `uncertainty` shows two digits if it begins with 1 or 2, else one. Negative
/// where whole tens are meant.
export function placesOf(uncertainty: number): number {
  if (!(uncertainty > 0) || !Number.isFinite(uncertainty)) return 3
  const size = Math.floor(Math.log10(uncertainty))
  const first = uncertainty / 10 ** size
  const kept = first < 2.95 ? 1 : 0
  // 0.0996 is written 0.10: rounding made it begin with 1.
  return kept === 0 && first >= 9.5 ? -size : kept - size
}

/// `value` rounded to `places` behind the mark, which may be negative: 2532 to -1 is 2530.
export function rounded(value: number, places: number): string {
  if (places >= 0) return fixed(value, Math.min(places, 12))
  const unit = 10 ** -places
  return fixed(Math.round(value / unit) * unit, 0)
}

/// "17.040 ± 0.023 N/m". An uncertainty below a hundred thousandth of the value is written in brackets behind
/// its last digit: "1.408 398 8(9) Hz".
export function withUncertainty(value: number, uncertainty: number | null, unit = ''): string {
  if (uncertainty === null || !(uncertainty > 0)) return withUnit(rounded(value, placesToShow(value)), unit)
  const places = placesOf(uncertainty)
  if (uncertainty < 1e-5 * Math.abs(value) && places > 3) return withUnit(inBrackets(value, uncertainty, places), unit)
  return withUnit(`${rounded(value, places)}${space}±${space}${rounded(uncertainty, places)}`, unit)
}

/// Both ends of an interval with the digits that half its width deserves, or half the width that it had before one
/// end was cut off: "16.99 to 17.09".
export function interval(low: number, high: number, to: string, half = (high - low) / 2): string {
  const places = placesOf(half)
  return `${grouped(rounded(low, places))}${space}${to} ${grouped(rounded(high, places))}`
}

/// Four digits of a value that stands alone.
function placesToShow(value: number): number {
  return value === 0 ? 0 : Math.max(0, 3 - Math.floor(Math.log10(Math.abs(value))))
}

function inBrackets(value: number, uncertainty: number, places: number): string {
  const units = Math.round(uncertainty * 10 ** places)
  return `${grouped(rounded(value, places))}(${units})`
}

/// From five digits behind the mark on in groups of three, as 1.408 398 8.
export function grouped(text: string): string {
  const [whole, mark, part] = text.split(/([.,])/)
  if (part === undefined || part.length < 5) return text
  return `${whole}${mark}${part.replace(/(\d{3})(?=\d)/g, '$1\u202f')}`
}
