// Lines as browsers draw them fast: of few points and, where no graphics card helps, one pixel wide.

/** Between gaps, which are pairs of NaN. */
function* stretches(points: ArrayLike<number>): Generator<[from: number, to: number]> {
  let from = 0
  for (let i = 0; i <= points.length; i += 2) {
    if (i < points.length && !Number.isNaN(points[i]!) && !Number.isNaN(points[i + 1]!)) continue
    if (i > from) yield [from, i]
    from = i + 2
  }
}

/** Without the points that lie within `off` [px] of the line between those that stay; ends and turns stay. */
export function thinned(points: ArrayLike<number>, off: number): Float32Array {
  const kept = new Float32Array(points.length)
  let count = 0
  for (const [from, to] of stretches(points)) {
    if (count > 0) {
      kept[count++] = NaN
      kept[count++] = NaN
    }
    count = thinStretch(points, from, to, off, kept, count)
  }
  return kept.subarray(0, count)
}

/**
 * From each point that stays, the directions that pass all points since within `off` are a cone that narrows.
 * Writes from `count` on; how many there are then.
 */
function thinStretch(points: ArrayLike<number>, from: number, to: number, off: number, kept: Float32Array, count: number): number {
  let x0 = points[from]!
  let y0 = points[from + 1]!
  // the cone's edges; none at first
  let lowX = 0
  let lowY = 0
  let highX = 0
  let highY = 0
  let open = true
  let reached = 0
  kept[count++] = x0
  kept[count++] = y0
  for (let i = from + 2; i < to; i += 2) {
    let x = points[i]! - x0
    let y = points[i + 1]! - y0
    let far = Math.sqrt(x * x + y * y)
    if (far < reached - off || (!open && far > off && (lowX * y - lowY * x < 0 || x * highY - y * highX < 0))) {
      x0 = points[i - 2]!
      y0 = points[i - 1]!
      kept[count++] = x0
      kept[count++] = y0
      x = points[i]! - x0
      y = points[i + 1]! - y0
      far = Math.sqrt(x * x + y * y)
      open = true
      reached = 0
    }
    reached = Math.max(reached, far)
    if (far <= off) continue
    const sine = off / far
    const cosine = Math.sqrt(1 - sine * sine)
    const toLowX = x * cosine + y * sine
    const toLowY = y * cosine - x * sine
    const toHighX = x * cosine - y * sine
    const toHighY = y * cosine + x * sine
    if (open || lowX * toLowY - lowY * toLowX > 0) {
      lowX = toLowX
      lowY = toLowY
    }
    if (open || toHighX * highY - toHighY * highX > 0) {
      highX = toHighX
      highY = toHighY
    }
    open = false
  }
  if (to - from > 2) {
    kept[count++] = points[to - 2]!
    kept[count++] = points[to - 1]!
  }
  return count
}

/** The line beside `points`, `by` [px] to its right. */
export function beside(points: ArrayLike<number>, by: number): Float32Array {
  const moved = new Float32Array(points.length).fill(NaN)
  for (const [from, to] of stretches(points))
    for (let i = from; i < to; i += 2) {
      const [a, b] = [Math.max(from, i - 2), Math.min(to - 2, i + 2)]
      const [x, y] = [points[b]! - points[a]!, points[b + 1]! - points[a + 1]!]
      const length = Math.sqrt(x * x + y * y) || 1
      moved[i] = points[i]! - (y / length) * by
      moved[i + 1] = points[i + 1]! + (x / length) * by
    }
  return moved
}
