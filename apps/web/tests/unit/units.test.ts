import { expect, it } from 'vitest'
import { energyUnitOf, forceUnitOf } from '../../src/simulate/units'

it('units suit the size, and nothing has the plain one', () => {
  expect([0, 4e-5, 0.02, 4.5, 9999, 212963, 5e7].map((size) => energyUnitOf(size).name)).toEqual(['J', 'µJ', 'mJ', 'J', 'J', 'kJ', 'MJ'])
  expect([0, 0.02, 9, 400e3].map((size) => forceUnitOf(size).name)).toEqual(['N', 'mN', 'N', 'kN'])
  expect(400e3 * forceUnitOf(400e3).factor).toBe(400)
})
