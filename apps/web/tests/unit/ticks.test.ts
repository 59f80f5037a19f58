import { expect, test } from 'vitest'
import { roundLimits, ticksOf, tickText } from '../../src/plot/ticks'

const texts = (from: number, to: number, most: number) => {
  const { values, step } = ticksOf(from, to, most)
  return values.map((value) => tickText(value, step))
}

test('ticks stand at round numbers with a true minus', () => {
  expect(texts(-5, 5, 6)).toEqual(['−5.0', '−2.5', '0', '2.5', '5.0'])
  expect(texts(0, 25, 6)).toEqual(['0', '5', '10', '15', '20', '25'])
  expect(texts(0, 0.02, 6)).toEqual(['0', '0.005', '0.010', '0.015', '0.020'])
})

test('steps are 1, 2, 2.5 or 5 times a power of ten and never more than asked', () => {
  for (let span = 1e-6; span < 1e6; span *= 1.37)
    for (const most of [4, 5, 6, 7]) {
      const { values, step } = ticksOf(-0.3 * span, 0.7 * span, most)
      const digits = step / 10 ** Math.floor(Math.log10(step) + 1e-9)
      expect([1, 2, 2.5, 5].some((each) => Math.abs(each - digits) < 1e-9)).toBe(true)
      expect(values.length).toBeLessThanOrEqual(most)
      expect(values.length).toBeGreaterThanOrEqual(2)
    }
})

test('limits hold the data and end at ticks', () => {
  expect(roundLimits(-4.9, 4.9)).toEqual([-5, 5])
  for (let size = 1e-5; size < 1e5; size *= 1.7) {
    const [from, to] = roundLimits(-0.9 * size, size)
    expect(from).toBeLessThanOrEqual(-0.9 * size * (1 - 1e-9))
    expect(to).toBeGreaterThanOrEqual(size * (1 - 1e-9))
    const { values } = ticksOf(from, to, 6)
    expect(values[0]).toBeCloseTo(from, 9)
    expect(values.at(-1)).toBeCloseTo(to, 9)
  }
})
