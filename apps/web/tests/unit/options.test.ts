import { expect, test } from 'vitest'
import { commandLine, coreOptions, methodsOf, studyFile } from '../../src/simulate/options'
import { simulateDefaults } from '../../src/simulate/state'
import { moved, valueAt, wayOf, type Scale } from '../../src/controls/scale'

test('the command line says all that differs from nothing', () => {
  expect(commandLine(simulateDefaults)).toBe(
    'cromer simulate --mass 1 --stiffness 9 --damping 0.2 --drive-amplitude 1 --drive-frequency 3 --position 0' +
      ' --method exact --method forward-euler --method euler-cromer --method implicit-euler --step 0.025 --until 25',
  )
  expect(studyFile(simulateDefaults, 'A', 'B', {})).toContain('damping = "0.2 kg/s"')
})

test('of two masses the command has their network', () => {
  expect(commandLine({ ...simulateDefaults, second: true, cubic: 3, methods: ['exact', 'rk4'] })).toBe('cromer simulate --network two.toml --method exact --method rk4 --step 0.025 --until 25')
})

test('without an exact solution Dormand-Prince stands in', () => {
  expect(methodsOf({ ...simulateDefaults, cubic: 1 })[0]).toBe('dormand-prince')
  expect(methodsOf({ ...simulateDefaults, cubic: 1, methods: ['rk4'] })).toEqual(['rk4'])
})

test('of a long run only some states are kept', () => {
  expect(coreOptions({ ...simulateDefaults, step: 0.0001, until: 100 })).toContainEqual(['every', '50'])
})

test('sliders come back to their values and always move', () => {
  const scales: Scale[] = [
    { least: 0.01, most: 100, kind: 'ratio' }, { least: 0, most: 10, kind: 'fine' }, { least: -2, most: 2, kind: 'even' },
  ]
  for (const scale of scales) {
    for (let way = 0; way <= 1; way += 0.013) expect(wayOf(scale, valueAt(scale, way))).toBeCloseTo(way, 1)
    expect(moved(scale, scale.least, 1)).toBeGreaterThan(scale.least)
    expect(moved(scale, scale.most, -1)).toBeLessThan(scale.most)
  }
})
