import { expect, it } from 'vitest'
import { presetOf, presets, stateOf, type PresetName } from '../../src/simulate/presets'
import { simulateDefaults } from '../../src/simulate/state'

it('an example is on until a control leaves it', () => {
  expect(presetOf(simulateDefaults)).toBe('')
  for (const name of Object.keys(presets) as PresetName[]) {
    const on = { ...simulateDefaults, cubic: 3, velocity: 1, ...stateOf(name) }
    expect(presetOf(on)).toBe(name)
    // what is no part of it
    expect(presetOf({ ...on, methods: ['rk4'], quantity: 'velocity', forces: false })).toBe(name)
    for (const key of ['mass', 'position', 'velocity', 'step', 'cubic', 'friction'] as const) expect(presetOf({ ...on, [key]: on[key] + 1 })).toBe('')
  }
})
