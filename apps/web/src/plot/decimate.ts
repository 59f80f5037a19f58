// Curves of any length as lines of at most a few points per pixel column.

export type ToPixel = (value: number) => number
const far = 1e5 // [px] further out is cut here: what canvases can draw

const cut = (pixel: number): number => Math.max(-far, Math.min(far, pixel))

/** The first index with x >= value; x rises. */
export function firstFrom(x: Float64Array, value: number): number {
  let low = 0
  let high = x.length
  while (low < high) {
    const middle = (low + high) >> 1
    if (x[middle]! < value) low = middle + 1
    else high = middle
  }
  return low
}

/** Pairs of pixels; NaN pairs part the line at gaps. Of crowded columns the first, least, most and last value are kept. */
export function lineOf(x: Float64Array, y: Float64Array, toX: ToPixel, toY: ToPixel, from: number, to: number): Float32Array {
  const begin = Math.max(0, firstFrom(x, from) - 1)
  const end = Math.min(x.length, firstFrom(x, to) + 2)
  const columns = Math.max(1, Math.abs(toX(to) - toX(from)))
  if (end - begin <= 4 * columns) return everyPoint(x, y, toX, toY, begin, end)
  const points: number[] = []
  for (let i = begin; i < end; ) {
    const column = Math.round(toX(x[i]!))
    let least = i
    let most = i
    let last = i
    const first = i
    let gap = false
    for (; i < end && Math.round(toX(x[i]!)) === column; ++i) {
      const value = y[i]!
      if (!Number.isFinite(value)) {
        gap = true
        continue
      }
      if (!(value >= y[least]!)) least = i
      if (!(value <= y[most]!)) most = i
      last = i
    }
    const order = least < most ? [first, least, most, last] : [first, most, least, last] // in their order in time
    for (const each of order) points.push(toX(x[each]!), cut(toY(y[each]!)))
    if (gap) points.push(NaN, NaN)
  }
  return Float32Array.from(points)
}

/** Every point in its order: also of curves that go back, as phase plots do. */
export function everyPoint(
  x: Float64Array, y: Float64Array, toX: ToPixel, toY: ToPixel, begin = 0, end = x.length,
): Float32Array {
  const points = new Float32Array(2 * Math.max(0, end - begin))
  let n = 0
  for (let i = begin; i < end; ++i) {
    const px = cut(toX(x[i]!))
    const py = cut(toY(y[i]!))
    // a step that cannot be seen is left out
    if (n >= 2 && Math.abs(px - points[n - 2]!) + Math.abs(py - points[n - 1]!) < 0.3 && i + 1 < end) continue
    points[n++] = px
    points[n++] = py
  }
  return points.subarray(0, n)
}

/** y at `x`, between two points on the line that joins them, of `smooth` curves on a cubic; NaN outside. */
export function valueAtX(xs: Float64Array, ys: Float64Array, x: number, smooth = false): number {
  const i = firstFrom(xs, x)
  const last = xs.length - 1
  // n steps that fill the run may end a rounding before it
  if (i > last) return x - xs[last]! <= 1e-12 * Math.abs(x) ? ys[last]! : NaN
  if (xs[i] === x) return ys[i]!
  if (i === 0) return NaN
  const step = xs[i]! - xs[i - 1]!
  const rise = ys[i]! - ys[i - 1]!
  const part = (x - xs[i - 1]!) / step
  const bend = smooth ? bendOf(xs, ys, i, part) : 0
  return ys[i - 1]! + part * (rise + (1 - part) * bend)
}

const gap = 3 // times as long as the steps beside it: what happens in it is not known

/** What the cubic between points i - 1 and i, with the slopes of parabolas through three points, adds to the line. */
function bendOf(xs: Float64Array, ys: Float64Array, i: number, part: number): number {
  const step = xs[i]! - xs[i - 1]!
  const rise = ys[i]! - ys[i - 1]!
  const before = i > 1 ? xs[i - 1]! - xs[i - 2]! : Infinity
  const after = i + 1 < xs.length ? xs[i + 1]! - xs[i]! : Infinity
  if (xs.length < 3 || step > gap * Math.min(before, after)) return 0
  const bend = (1 - part) * (step * slopeAt(xs, ys, i - 1) - rise) - part * (step * slopeAt(xs, ys, i) - rise)
  return Number.isFinite(bend) ? bend : 0
}

function slopeAt(xs: Float64Array, ys: Float64Array, i: number): number {
  const first = Math.max(0, Math.min(xs.length - 3, i - 1))
  const [a, b, c] = [xs[first]!, xs[first + 1]!, xs[first + 2]!]
  const secant = (ys[first + 1]! - ys[first]!) / (b - a)
  const next = (ys[first + 2]! - ys[first + 1]!) / (c - b)
  return secant + ((next - secant) / (c - a)) * (2 * xs[i]! - a - b)
}

/** Of a smooth curve that has few points for its width: more of them, a pixel apart. */
export function bent(x: Float64Array, y: Float64Array, toX: ToPixel, from: number, to: number): { x: Float64Array; y: Float64Array } {
  const [a, b] = [Math.max(from, x[0] ?? Infinity), Math.min(to, x.at(-1) ?? -Infinity)]
  const count = Math.ceil(toX(b) - toX(a))
  if (!(count > 0) || firstFrom(x, b) - firstFrom(x, a) > count) return { x, y }
  const at = Float64Array.from({ length: count + 1 }, (_, i) => (i < count ? a + ((b - a) * i) / count : b))
  return { x: at, y: at.map((each) => valueAtX(x, y, each, true)) }
}
