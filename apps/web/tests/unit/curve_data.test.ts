import { describe, expect, it } from 'vitest'
import { csvOf } from '../../src/keep/csv'
import { withData, type Curve } from '../../src/plot/curve'
import { extentOf } from '../../src/plot/extent'
import { endsOf, limitsOf } from '../../src/plot/limits'

const many = 300_000
const long = Float64Array.from({ length: many }, (_, i) => Math.sin(i / 100))

describe('a curve that is a picture of its data', () => {
  const curve: Curve = {
    meaning: 'measured', name: 'measured', x: Float64Array.of(0.5, 0.5), y: Float64Array.of(-1, 1),
    data: () => ({ x: Float64Array.of(0, 1, 2), y: Float64Array.of(0.1, 0.2, 0.3) }),
  }
  it('is saved as the data', () => {
    const axis = (plain: string, unit: string) => ({ name: plain, plain, unit })
    expect(csvOf(axis('time', 's'), axis('position', 'm'), [withData(curve)])).toBe(
      'time (s),measured: position (m)\n0,0.1\n1,0.2\n2,0.3\n',
    )
  })
  it('is itself where it has none', () => {
    const plain: Curve = { ...curve, data: undefined }
    expect(withData(plain)).toBe(plain)
  })
})

describe('ends', () => {
  it('are found of more values than a call has arguments', () => {
    const [least, most] = endsOf(long)!
    expect(least).toBeCloseTo(-1, 4)
    expect(most).toBeCloseTo(1, 4)
    expect(extentOf(long).size).toBe(Math.max(-least, most))
    expect(limitsOf([{ meaning: 'measured', name: '', x: long, y: long }], 'y')).toEqual([-1, 1])
  })
  it('are those of the finite values', () => {
    expect(endsOf(Float64Array.of(NaN, -3, Infinity, 2, -Infinity))).toEqual([-3, 2])
    expect(endsOf(Float64Array.of(NaN))).toBeNull()
    expect(extentOf(Float64Array.of(NaN, -3, 2)).size).toBe(3)
    expect(extentOf(new Float64Array()).size).toBe(0)
  })
})
