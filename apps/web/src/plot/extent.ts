// How far a column of numbers reaches. Asked many times of each column, looked for once.

/** Of its finite numbers; `least` is above `most` where there are none. */
export interface Extent {
  least: number
  most: number
  size: number // the largest absolute one
  whole: boolean // all are finite
}

const known = new WeakMap<Float64Array, Extent>()

/** The column does not change afterwards. */
export function extentOf(values: Float64Array): Extent {
  const before = known.get(values)
  if (before) return before
  let [least, most, finite] = [Infinity, -Infinity, 0]
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!
    if (!(Math.abs(value) < Infinity)) continue
    ++finite
    if (value < least) least = value
    if (value > most) most = value
  }
  const extent = { least, most, size: Math.max(0, most, -least), whole: finite === values.length }
  known.set(values, extent)
  return extent
}
