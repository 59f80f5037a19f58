import { expect, test } from 'vitest'
import { spread } from '../../src/plot/labels'

const at = (...ys: number[]) => ys.map((y) => ({ y, height: 15 }))

test('words that have room stay where they are', () => {
  expect(spread(at(20, 60, 100), 0, 200).map(({ y }) => y)).toEqual([20, 60, 100])
})

test('words at one height are moved apart about it, in their order', () => {
  const placed = spread([{ y: 100, height: 15, name: 'a' }, { y: 100, height: 15, name: 'b' }], 0, 200)
  expect(placed.map(({ name }) => name)).toEqual(['a', 'b'])
  expect(placed[1]!.y - placed[0]!.y).toBe(15)
  expect(placed[0]!.y + placed[1]!.y).toBe(200)
})

test('none covers another and none leaves the frame', () => {
  for (let seed = 1; seed < 50; ++seed) {
    const labels = Array.from({ length: 8 }, (_, i) => ({ y: (seed * 37 * (i + 3)) % 180, height: i % 3 ? 15 : 30 }))
    const placed = spread(labels, 8, 300)
    placed.forEach((label, i) => {
      expect(label.y).toBeGreaterThanOrEqual(8 - 1e-9)
      expect(label.y + label.height).toBeLessThanOrEqual(300 + 1e-9)
      if (i > 0) expect(label.y - placed[i - 1]!.y).toBeGreaterThanOrEqual(placed[i - 1]!.height - 1e-9)
    })
  }
})
