import { expect, test } from 'vitest'
import { firstFrom, lineOf, valueAtX } from '../../src/plot/decimate'

const same = (value: number) => value

test('of crowded columns the extremes stay', () => {
  const count = 1e5
  const x = Float64Array.from({ length: count }, (_, i) => (i / count) * 100)
  const y = x.map((value) => Math.sin(value * 50))
  y[50_001] = 17
  const line = lineOf(x, y, same, same, 0, 100)
  expect(line.length / 2).toBeLessThan(500)
  expect(Math.max(...line.filter((_, i) => i % 2 === 1))).toBe(17)
})

test('a gap parts the line', () => {
  const x = Float64Array.of(0, 1, 2, 3)
  const line = lineOf(x, Float64Array.of(0, 1, NaN, 3), (value) => 100 * value, same, 0, 3)
  expect(Number.isNaN(line[5])).toBe(true)
})

test('values between samples lie on the line that joins them', () => {
  const x = Float64Array.of(0, 1, 3)
  const y = Float64Array.of(0, 2, 6)
  expect(valueAtX(x, y, 2)).toBe(4)
  expect(valueAtX(x, y, 3)).toBe(6)
  expect(valueAtX(x, y, 3.1)).toBeNaN()
  expect(firstFrom(x, 0.5)).toBe(1)
})
