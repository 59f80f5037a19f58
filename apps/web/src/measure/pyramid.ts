// Least and greatest value of any stretch of a long recording, quickly: what a plot needs of 10^6 samples is
// two numbers for each column of pixels.
import { firstFrom } from '../plot/decimate'

/// Levels of pairs: level k holds least and greatest of every 16^(k+1) samples. NaN is left out; where all of a
/// stretch is missing both are NaN.
export interface Pyramid {
  values: Float64Array
  low: Float64Array[]
  high: Float64Array[]
}

const fan = 16

/// O(n) once; 1/15 of the samples' memory twice.
export function pyramidOf(values: Float64Array): Pyramid {
  const low: Float64Array[] = []
  const high: Float64Array[] = []
  let below: [Float64Array, Float64Array] = [values, values]
  while (below[0].length > fan) {
    const count = Math.ceil(below[0].length / fan)
    const next: [Float64Array, Float64Array] = [new Float64Array(count), new Float64Array(count)]
    for (let i = 0; i < count; ++i) {
      const [least, greatest] = scan(below[0], below[1], i * fan, Math.min((i + 1) * fan, below[0].length))
      next[0][i] = least
      next[1][i] = greatest
    }
    low.push(next[0])
    high.push(next[1])
    below = next
  }
  return { values, low, high }
}

function scan(low: Float64Array, high: Float64Array, first: number, end: number): [number, number] {
  let least = NaN
  let greatest = NaN
  for (let i = first; i < end; ++i) {
    // A comparison with NaN is false either way: these take the first number and skip what is missing.
    if (!(low[i]! >= least)) least = Number.isNaN(low[i]!) ? least : low[i]!
    if (!(high[i]! <= greatest)) greatest = Number.isNaN(high[i]!) ? greatest : high[i]!
  }
  return [least, greatest]
}

/// Least and greatest of the samples first … end - 1: O(log n).
export function rangeOf(pyramid: Pyramid, first: number, end: number): [number, number] {
  let least = NaN
  let greatest = NaN
  const take = (low: Float64Array, high: Float64Array, from: number, to: number) => {
    const [a, b] = scan(low, high, from, to)
    if (!(a >= least) && !Number.isNaN(a)) least = a
    if (!(b <= greatest) && !Number.isNaN(b)) greatest = b
  }
  let low = pyramid.values
  let high = pyramid.values
  let from = Math.max(0, first)
  let to = Math.min(end, low.length)
  for (let level = 0; from < to; ++level) {
    const firstWhole = Math.ceil(from / fan)
    const endWhole = Math.floor(to / fan)
    if (firstWhole >= endWhole || level >= pyramid.low.length) {
      take(low, high, from, to)
      break
    }
    take(low, high, from, firstWhole * fan)
    take(low, high, endWhole * fan, to)
    low = pyramid.low[level]!
    high = pyramid.high[level]!
    from = firstWhole
    to = endWhole
  }
  return [least, greatest]
}

export interface Columns {
  t: Float64Array // the middle of each column [s]
  low: Float64Array
  high: Float64Array
}

/// One pair for each of `count` columns between the times from and to. A column borrows the first sample of
/// the next one, so that what is drawn has no holes where samples are.
export function columnsOf(pyramid: Pyramid, t: Float64Array, from: number, to: number, count: number): Columns {
  const columns = { t: new Float64Array(count), low: new Float64Array(count), high: new Float64Array(count) }
  const width = (to - from) / count
  let first = firstFrom(t, from)
  for (let i = 0; i < count; ++i) {
    const end = firstFrom(t, from + (i + 1) * width)
    const [low, high] = first < end ? rangeOf(pyramid, first, Math.min(end + 1, t.length)) : [NaN, NaN]
    columns.t[i] = from + (i + 0.5) * width
    columns.low[i] = low
    columns.high[i] = high
    first = end
  }
  return columns
}
