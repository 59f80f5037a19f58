// From a slider's way (0 to 1) to its value and back.
export interface Scale {
  least: number
  most: number
  /** `even`, `ratio` (logarithmic), or `fine`: by the cube, finer near zero, for quantities that may be 0. */
  kind: 'even' | 'ratio' | 'fine'
}

export function wayOf({ least, most, kind }: Scale, value: number): number {
  const way =
    kind === 'ratio' ? Math.log(value / least) / Math.log(most / least)
    : kind === 'fine' ? Math.cbrt(Math.max(0, value - least) / (most - least))
    : (value - least) / (most - least)
  return Number.isFinite(way) ? Math.min(1, Math.max(0, way)) : 0
}

/** Rounded to three digits (even: to a thousandth of the range), so that fields show what is meant. */
export function valueAt({ least, most, kind }: Scale, way: number): number {
  const at = Math.min(1, Math.max(0, way))
  if (kind === 'ratio') return Number((least * (most / least) ** at).toPrecision(3))
  if (kind === 'fine') return Number((least + (most - least) * at ** 3).toPrecision(3))
  const step = 10 ** Math.floor(Math.log10((most - least) / 400))
  return Number((Math.round((least + (most - least) * at) / step) * step).toPrecision(12))
}

/** The next value from `value`, `steps` hundredths of the way on (Page: ten, End: to the end). */
export function moved(scale: Scale, value: number, steps: number): number {
  for (let more = 1; more < 64; more *= 2) {
    const next = valueAt(scale, wayOf(scale, value) + (steps * more) / 200)
    if (next !== value) return next
  }
  return value
}
