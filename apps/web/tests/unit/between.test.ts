import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { read, start } from '../../src/core/core'
import type { Options } from '../../src/core/types'
import { valueAtX } from '../../src/plot/decimate'
import { betweenOptions, coreOptions } from '../../src/simulate/options'
import { simulateDefaults, type SimulateState } from '../../src/simulate/state'
import { english } from '../../src/words/said'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

describe.skipIf(!existsSync(built))('between the steps', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  const run = (options: Options) => {
    const answer = read<'motion'>(core.answer('motion', options))
    if (answer.status === 2) throw new Error(english(answer.document.message))
    return answer.document.runs[0]!.states
  }
  const of = (part: Partial<SimulateState>): SimulateState => ({ ...simulateDefaults, methods: ['exact'], ...part })

  it.each<[string, Partial<SimulateState>]>([
    ['a driven swing', { step: 0.5 }],
    ['a free one', { driveAmplitude: 0, position: 1, step: 0.5 }],
    ['the default step', {}],
    ['a drive faster than the swing', { driveFrequency: 20, step: 0.2 }],
    ['many kept steps in one', { until: 2000, step: 0.05 }],
    ['overdamped', { damping: 30, driveAmplitude: 0, position: 1, step: 1 }],
    ['an end between two steps', { until: 25.3, step: 0.7 }],
    ['a last step that rounding puts before the end', { until: 25.2, step: 0.7 }],
    ['a spring that hardens', { cubic: 2, position: 1, step: 0.4 }],
  ])('the solution is known: %s', (_, part) => {
    const state = of(part)
    const states = run(betweenOptions(state) ?? coreOptions(state))
    const size = Math.max(...states.x.map(Math.abs))
    const [method, ...others] = coreOptions(state).filter(([name]) => !['step', 'until', 'every'].includes(name)).reverse()
    expect(method![0]).toBe('method')
    for (const part of [0.0007, 0.071, 0.33331, 0.5, 0.9876, 1]) {
      const t = part * state.until
      const { x, v } = run([...others, method!, ['step', String(t)], ['until', String(t)]])
      expect(Math.abs(valueAtX(states.t, states.x, t, true) - x.at(-1)!) / size, `x(${t})`).toBeLessThan(2e-4)
      expect(Math.abs(valueAtX(states.t, states.v, t, true) - v.at(-1)!) / Math.max(...states.v.map(Math.abs)), `v(${t})`).toBeLessThan(2e-4)
    }
  })

  it('is asked for where steps are coarse, of methods that know it', () => {
    expect(betweenOptions(of({ step: 0.01 }))).toBeNull()
    expect(betweenOptions(of({ step: 0.5, methods: ['rk4'] }))).toBeNull()
    expect(betweenOptions(of({ step: 0.5, methods: ['rk4', 'exact'] }))!.filter(([name]) => name === 'method')).toEqual([['method', 'exact']])
  })
})

it('a smooth curve bends between its points, ends at its ends and is straight over a gap', () => {
  const x = Float64Array.from({ length: 40 }, (_, i) => i / 5 + (i >= 20 ? 4 : 0))
  const y = x.map(Math.sin)
  for (const at of [0.1, 1.37, 3.5, 8.55]) expect(Math.abs(valueAtX(x, y, at, true) - Math.sin(at))).toBeLessThan(1e-3)
  expect(valueAtX(x, y, 6.4, true)).toBe(valueAtX(x, y, 6.4))
  expect(valueAtX(x, y, 0, true)).toBe(0)
  expect(valueAtX(x, y, 11.9, true)).toBeNaN()
  expect(valueAtX(Float64Array.of(0, 1), Float64Array.of(0, 2), 0.5, true)).toBe(1)
})
