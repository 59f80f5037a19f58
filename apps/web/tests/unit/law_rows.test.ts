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
