import { describe, expect, it } from 'vitest'
import { interval, withUncertainty } from '../../src/measure/uncertain'
import { scaleFor } from '../../src/measure/units'

describe('a value with its uncertainty', () => {
  it.each([
    [17.040014, 0.0234927, 'N/m', '17.040 ± 0.023 N/m'],
    [17.0437, 0.0361, 'N/m', '17.04 ± 0.04 N/m'],
    [0.785, 0.0187, 'g/s', '0.785 ± 0.019 g/s'],
    [3.0056, 0.0175, '', '3.006 ± 0.018'],
    [2532.456, 12.1, '', '2532 ± 12'],
    [25324.56, 38.2, '', '25320 ± 40'],
    [1.40839883, 9.35e-7, 'Hz', '1.408\u202f398\u202f8(9) Hz'],
    [-0.5, 0.0996, 'm', '−0.50 ± 0.10 m'],
    [5, 0.0297, 's', '5.00 ± 0.03 s'],
    [12.5, null, 'cm', '12.50 cm']
  ])('%f ± %f %s', (value, uncertainty, unit, text) => {
    expect(withUncertainty(value, uncertainty, unit)).toBe(text.replaceAll(' ', '\u00a0'))
  })
  it('gives both ends of an interval the same digits', () => {
    expect(interval(16.99396, 17.08606, 'to')).toBe('16.99\u00a0to 17.09')
  })
})

describe('the unit', () => {
  it('suits the size', () => {
    expect(scaleFor(0.000785, 'kg/s')).toEqual({ factor: 1000, unit: 'g/s' })
    expect(scaleFor(0.2, 'kg/s')).toEqual({ factor: 1, unit: 'kg/s' })
    expect(scaleFor(0.0003, 'm').unit).toBe('mm')
    expect(scaleFor(0.036, 'm').unit).toBe('cm')
    expect(scaleFor(3, '1').unit).toBe('')
  })
})
