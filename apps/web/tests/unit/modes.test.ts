import { describe, expect, it } from 'vitest'
import type { Estimate } from '../../src/core/types'
import { partOfShape, read } from '../../src/measure/modes'

describe('a part of a shape', () => {
  it('has a sign where it swings with the largest or against it', () => {
    expect(partOfShape([1, 0])).toBe('1.00')
    expect(partOfShape([-0.52, 0.03])).toBe('−0.52')
    expect(partOfShape([0, 0])).toBe('0.00')
  })
  it('has a phase where it clearly does neither', () => {
    expect(partOfShape([0.3, 0.4])).toBe('0.50\u00a0∠\u00a053°')
    expect(partOfShape([0, -0.5])).toBe('0.50\u00a0∠\u00a0−90°')
    expect(partOfShape([0.3, 0.4], [0.2, 0.21])).toBe('0.50')
    expect(partOfShape([0.3, 0.4], [0.2, 0.19])).toBe('0.50\u00a0∠\u00a053°')
  })
  it('is not written where it is not known', () => {
    expect(partOfShape([null, 0])).toBe('–')
  })
})

describe('an estimate', () => {
  const of = (value: number | null, error: number | null, low: number | null, high: number | null) =>
    ({ value, standard_error: error, confidence_95: [low, high], unit: '' }) as unknown as Estimate
  it('has its uncertainty and the ends of its interval', () => {
    expect(read(of(1.7457, 0.0014, 1.7428, 1.7487), 1, 'Hz', 'to')).toEqual(['1.7457\u00a0±\u00a00.0014\u00a0Hz', '1.743\u00a0to 1.749'])
    expect(read(of(0.0061, 0.0004, 0.0052, 0.007), 100, '%', 'bis')).toEqual(['0.61\u00a0±\u00a00.04\u00a0%', '0.52\u00a0bis 0.70'])
  })
  it('stands alone where they are not known', () => {
    expect(read(of(2, null, null, null), 1, 'Hz', 'to')).toEqual(['2.000\u00a0Hz', ''])
    expect(read(of(2, 0, 2, 2), 1, 'Hz', 'to')).toEqual(['2.000\u00a0Hz', ''])
    expect(read(of(null, null, null, null), 1, 'Hz', 'to')).toEqual(['–', ''])
  })
})
