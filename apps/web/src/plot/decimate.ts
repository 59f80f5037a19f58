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

/** y at `x`, between two samples on the line that joins them; NaN outside. */
export function valueAtX(xs: Float64Array, ys: Float64Array, x: number): number {
  const i = firstFrom(xs, x)
  if (i >= xs.length) return NaN
  if (xs[i] === x) return ys[i]!
  if (i === 0) return NaN
  const part = (x - xs[i - 1]!) / (xs[i]! - xs[i - 1]!)
  return ys[i - 1]! + part * (ys[i]! - ys[i - 1]!)
}
