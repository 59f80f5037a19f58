import { afterEach, expect, test } from 'vitest'
import { asTyped, exactly, fixed, percent, numberOf, significant, typeset, useComma, withUnit } from '../../src/look/numbers'

afterEach(() => useComma(false))

test('numbers have the digits asked for and a true minus', () => {
  expect(significant(0.025, 3)).toBe('0.0250')
  expect(significant(-0.012496, 3)).toBe('−0.0125')
  expect(significant(1234567, 3)).toBe('1234567')
  expect(significant(1.5e-9, 2)).toBe('1.5\u202f×\u202f10⁻⁹')
  expect(fixed(-0.0001, 2)).toBe('0.00')
  expect(significant(NaN, 3)).toBe('–')
})

test('sentences have their numbers typeset, but for what was typed', () => {
  expect(typeset('viscous+cubic (cubic -1.69e-06 ± 4e-07)')).toBe('viscous+cubic (cubic −1.69\u202f×\u202f10⁻⁶ ± 4\u202f×\u202f10⁻⁷)')
  expect(typeset('kubische Feder -1,69e-06')).toBe('kubische Feder −1,69\u202f×\u202f10⁻⁶')
  expect(typeset('it must be positive, not -1 s')).toBe('it must be positive, not −1 s')
  const asTyped = '"1e-3 parsecs" in run-2e5.csv of 2020-01-02, „-1e3“'
  expect(typeset(asTyped)).toBe(asTyped)
})

test('a field shows all that was given', () => {
  expect(exactly(9)).toBe('9.00')
  expect(exactly(9.80665)).toBe('9.80665')
  expect(exactly(1e-7)).toBe('1.00\u202f×\u202f10⁻⁷')
})

test('units stand behind a no-break space; German has a comma', () => {
  expect(withUnit('2.997', 'rad/s')).toBe('2.997\u00a0rad/s')
  expect(percent(0.00063)).toBe('+0.06\u00a0%')
  expect(percent(-0.0043)).toBe('−0.43\u00a0%')
  useComma(true)
  expect(significant(0.025, 3)).toBe('0,0250')
})

test('what is shown can be typed again', () => {
  expect(asTyped('−0,5 m')).toBe('-0.5 m')
  expect(asTyped('217,6 ± 0,3 g')).toBe('217.6 ± 0.3 g')
  expect(numberOf('0,0094')).toBe(0.0094)
  expect(numberOf('−2')).toBe(-2)
  expect(numberOf('')).toBeNaN()
})

test('a comma that may set off thousands is not taken for a point, but in German', () => {
  for (const text of ['2,500 N/m', '1,000', '12,345,678', '−2,500']) expect(asTyped(text)).toContain(',')
  expect(numberOf('12,527')).toBe(12.527)
  expect(asTyped('0,125 m')).toBe('0.125 m')
  expect(asTyped('2,5000')).toBe('2.5000')
  useComma(true)
  expect(asTyped('2,500 N/m')).toBe('2.500 N/m')
})
