import { expect, it } from 'vitest'
import { rowsOf } from '../../src/measure/rows'
import { measure } from '../../src/words/en/measure'

const estimate = (value: number, unit: string) => ({ value, standard_error: 0.1 * value, confidence_95: [0.8 * value, 1.2 * value] as [number, number], unit })

it.each([['viscous', 'decay rate'], ['viscous+drag', 'viscous part of the decay rate'], ['viscous+cubic', 'viscous part of the decay rate']])(
  'the decay rate of %s is called %s',
  (law, name) => {
    const fit = { law, coefficients: ['decay_rate'], parameters: { decay_rate: estimate(0.05, '1/s') }, derived: {}, reynolds: null }
    expect(rowsOf(fit as unknown as Parameters<typeof rowsOf>[0], measure)[0]!.name).toBe(name)
  }
)

it('an interval that reaches far on one side keeps the value within', () => {
  const wide = { value: 93, standard_error: 13, confidence_95: [71, 480] as [number, number], unit: '1' }
  const fit = { law: 'viscous', coefficients: ['decay_rate'], parameters: { decay_rate: estimate(0.05, '1/s') }, derived: { quality_factor: wide }, reynolds: null }
  const row = rowsOf(fit as unknown as Parameters<typeof rowsOf>[0], measure).find((each) => each.key === 'quality_factor')!
  expect(row.interval).toBe('71\u00a0to 480')
})

it('the digits of an interval are those of the shown unit', () => {
  const wide = { value: 0.093, standard_error: 0.013, confidence_95: [0.071, 0.48] as [number, number], unit: 'm' }
  const fit = { law: 'viscous', coefficients: ['decay_rate'], parameters: { decay_rate: wide }, derived: {}, reynolds: null }
  const rows = rowsOf(fit as unknown as Parameters<typeof rowsOf>[0], measure).filter((each) => each.key === 'decay_rate')
  expect(rows.map((each) => each.value)).toEqual(['9.3\u00a0±\u00a01.3\u00a0cm'])
  expect(rows.map((each) => each.interval)).toEqual(['7.1\u00a0to 48.0'])
})
