import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { read, start } from '../../src/core/core'
import type { Motion, Options } from '../../src/core/types'
import { forceLooks, forcesAt, largestOf } from '../../src/simulate/forces'
import { askForces, betweenOptions, coreOptions } from '../../src/simulate/options'
import { simulateDefaults, type SimulateState } from '../../src/simulate/state'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

describe('the forces at a time', () => {
  const times = Float64Array.of(0, 1, 2, 3)
  const forces = { drive: Float64Array.of(1, 2, 3, 4), spring: Float64Array.of(0, -8, 2, 1), friction: Float64Array.of(-1, -1, 1, 1) }
  it('stand in one order, between the states on the line, friction as at the nearest', () => {
    expect(forcesAt(forces, times, 1.25, false)).toEqual([{ name: 'spring', value: -5.5 }, { name: 'friction', value: -1 }, { name: 'drive', value: 2.25 }])
    expect(forcesAt(forces, times, 1.75, false)[1]!.value).toBe(1)
    expect(forcesAt(forces, times, 3, false).map(({ value }) => value)).toEqual([1, 1, 4])
  })
  it('have the largest of the run as their scale', () => {
    expect(largestOf(forces)).toBe(8)
    expect(largestOf({})).toBe(0)
  })
})

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('the forces on the mass', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  const motionOf = (options: Options): Motion => {
    const answer = read<'motion'>(core.answer('motion', options))
    if (answer.status === 2) throw new Error(JSON.stringify(answer.document))
    return answer.document.runs[0]!
  }
  const stateOf = (part: Partial<SimulateState>): SimulateState => ({ ...simulateDefaults, until: 6, step: 0.001, methods: ['exact'], ...part })
  const laws: [string, Partial<SimulateState>][] = [
    ['spring, damping and drive', { position: 1 }],
    ['a cubic spring and drag', { cubic: 4, drag: 0.7, position: 1 }],
    ['friction', { friction: 0.6, position: 1, driveAmplitude: 0 }],
    ['friction under a drive that cannot always move it', { friction: 0.8, position: 0.4, driveFrequency: 1 }],
    ['van der Pol', { damping: -1, vanDerPol: 2, position: 0.2, driveAmplitude: 0 }],
    ['every smooth term', { quadratic: 1, oddQuadratic: 0.5, cubic: 2, quintic: 1, pendulum: 3, drag: 0.3, vanDerPol: 0.4, position: 0.8 }],
  ]
  it.each(laws)('add up to mass times acceleration: %s', (_, part) => {
    const s = stateOf({ mass: 1.7, ...part })
    const options = coreOptions(s)
    askForces(options, null)
    const { states, forces } = motionOf(options)
    const [{ t, v }, all] = [states, Object.entries(forces!)]
    expect(all.every(([name, values]) => name in forceLooks && values.length === t.length)).toBe(true)
    const scale = largestOf(forces!)
    let held = 0
    for (let i = 1; i + 1 < t.length; ++i) {
      // the acceleration jumps where friction turns
      if (forces!.friction && new Set([v[i - 1]!, v[i]!, v[i + 1]!].map(Math.sign)).size > 1) continue
      held += Number(v[i] === 0)
      const a = (v[i + 1]! - v[i - 1]!) / (t[i + 1]! - t[i - 1]!)
      const sum = all.reduce((sum, [, values]) => sum + values[i]!, 0)
      expect(Math.abs(sum - s.mass * a)).toBeLessThan(2e-5 * scale)
    }
    if (part.friction && part.driveFrequency) expect(held).toBeGreaterThan(50)
  })
  it('are those of the states where the motion is known best, of the method that the mass follows', () => {
    const s = stateOf({ step: 0.2, methods: ['exact', 'rk4'] })
    const [options, between] = [coreOptions(s), betweenOptions(s)!]
    askForces(options, between)
    expect(options.some(([name]) => name === 'forces')).toBe(false)
    const { states, forces } = motionOf(between)
    for (const t of [0.33, 2.5, 5.81]) {
      const [spring] = forcesAt(forces!, states.t, t, true)
      const [x] = forcesAt({ spring: states.x }, states.t, t, true)
      expect(spring!.value).toBeCloseTo(-9 * x!.value, 12)
    }
    const alone = coreOptions(stateOf({ methods: ['rk4'] }))
    askForces(alone, null)
    expect(alone.at(-1)).toEqual(['forces', 'rk4'])
    expect(motionOf(alone).forces!.drive!.length).toBe(6001)
  })
})
