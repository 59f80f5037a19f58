import { describe, expect, it } from 'vitest'
import { columnsOf, pyramidOf, rangeOf } from '../../src/measure/pyramid'
import { firstFrom } from '../../src/plot/decimate'

/// A motion with holes in it, from a small generator, so that every run sees the same.
function samples(count: number): Float64Array {
  let state = 7
  return Float64Array.from({ length: count }, (_, i) => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0
    return state % 97 === 0 ? NaN : Math.sin(i / 9) * 3 + state / 2 ** 32
  })
}

const plainly = (values: Float64Array) => {
  const there = [...values].filter((value) => !Number.isNaN(value))
  return there.length ? [Math.min(...there), Math.max(...there)] : [NaN, NaN]
}

describe('a pyramid of least and greatest values', () => {
  it('finds what a plain search finds', () => {
    const values = samples(5003)
    const pyramid = pyramidOf(values)
    for (let first = 0; first < 5003; first += 211)
      for (const length of [1, 2, 15, 16, 17, 255, 256, 300, 4096, 5003])
        expect(rangeOf(pyramid, first, first + length)).toEqual(plainly(values.slice(first, first + length)))
  })
  it('says that nothing is there where all is missing', () => {
    expect(rangeOf(pyramidOf(new Float64Array(100).fill(NaN)), 3, 90)).toEqual([NaN, NaN])
  })
  it('looks at few of a million samples', () => {
    const pyramid = pyramidOf(samples(1_000_000))
    let looks = 0
    const watched = new Proxy(pyramid.values, {
      get: (target, name) => {
        if (typeof name === 'string' && /^\d+$/.test(name)) ++looks
        return Reflect.get(target, name)
      }
    })
    rangeOf({ ...pyramid, values: watched as Float64Array }, 17, 999_983)
    expect(looks).toBeLessThanOrEqual(120)
  })
})

describe('columns of pixels', () => {
  const t = Float64Array.from({ length: 1000 }, (_, i) => i / 100)
  it('join to the next one and cover every sample', () => {
    const values = samples(1000)
    const columns = columnsOf(pyramidOf(values), t, 0, 10, 40)
    const [low, high] = plainly(values)
    expect(Math.min(...columns.low)).toBe(low)
    expect(Math.max(...columns.high)).toBe(high)
    for (let i = 0; i + 1 < 40; ++i) {
      expect(columns.low[i]).toBeLessThanOrEqual(columns.high[i + 1]!)
      expect(columns.high[i]).toBeGreaterThanOrEqual(columns.low[i + 1]!)
    }
  })
  it('are empty where there is no sample', () => {
    const columns = columnsOf(pyramidOf(samples(1000)), t, 20, 30, 5)
    expect([...columns.low].every(Number.isNaN)).toBe(true)
  })
  it('find the first sample at or after a time', () => {
    expect(firstFrom(t, 0.5)).toBe(50)
    expect(firstFrom(t, -1)).toBe(0)
    expect(firstFrom(t, 99)).toBe(1000)
  })
})
