import { describe, expect, it } from 'vitest'
import { beside, thinned } from '../../src/plot/thin'

const wave = (count: number) => {
  const points: number[] = []
  for (let i = 0; i < count; ++i) points.push((700 * i) / count, 150 * Math.sin((75 * i) / count))
  return points
}

/** Of a point from the line between two others. */
function distance(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [x, y] = [bx - ax, by - ay]
  const part = Math.max(0, Math.min(1, ((px - ax) * x + (py - ay) * y) / (x * x + y * y || 1)))
  return Math.hypot(px - ax - part * x, py - ay - part * y)
}

describe('a thinned line', () => {
  it('passes every point within the distance, with a part of the points', () => {
    const points = wave(3000)
    const kept = thinned(points, 0.1)
    expect(kept.length).toBeLessThan(points.length / 5)
    for (let i = 0; i < points.length; i += 2) {
      let nearest = Infinity
      for (let j = 0; j + 3 < kept.length; j += 2)
        nearest = Math.min(nearest, distance(points[i]!, points[i + 1]!, kept[j]!, kept[j + 1]!, kept[j + 2]!, kept[j + 3]!))
      expect(nearest).toBeLessThan(0.1001)
    }
  })
  it('keeps ends, spikes and gaps', () => {
    expect([...thinned([0, 0, 1, 0, 2, 0, 3, 0], 0.1)]).toEqual([0, 0, 3, 0])
    expect([...thinned([0, 0, 0, 5, 0, 9, 0, 2, 0, 4], 0.1)]).toEqual([0, 0, 0, 9, 0, 2, 0, 4])
    expect([...thinned([0, 0, 1, 1, NaN, NaN, 2, 2, 3, 3, NaN, NaN, 4, 4], 0.1)]).toEqual([0, 0, 1, 1, NaN, NaN, 2, 2, 3, 3, NaN, NaN, 4, 4])
    expect(thinned([], 0.1)).toHaveLength(0)
  })
})

describe('a line beside another', () => {
  it('keeps its distance', () => {
    expect([...beside([0, 0, 1, 0, 2, 0], 0.25)]).toEqual([0, 0.25, 1, 0.25, 2, 0.25])
    const points = wave(3000)
    const moved = beside(points, 0.5)
    for (let i = 0; i < points.length; i += 2) expect(Math.hypot(moved[i]! - points[i]!, moved[i + 1]! - points[i + 1]!)).toBeCloseTo(0.5, 4)
  })
  it('keeps gaps', () => {
    expect([...beside([0, 0, 1, 0, NaN, NaN, 5, 5], 1)]).toEqual([0, 1, 1, 1, NaN, NaN, 5, 5])
  })
})
