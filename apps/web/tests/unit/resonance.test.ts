import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { read, start } from '../../src/core/core'
import type { Options, ResonanceCurve, Task } from '../../src/core/types'
import { english } from '../../src/words/said'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

describe.skipIf(!existsSync(built))('the resonance curve', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  const ask = <T extends Task>(task: T, options: Options) => read<T>(core.answer(task, options))

  const law: Options = [
    ['stiffness', '9'], ['drive-amplitude', '1'], ['drive-frequency', '3'], ['step', '0.01'],
  ]
  function curves(methods: string[], options: Options): ResonanceCurve[] {
    const others = law.filter(([name]) => !options.some(([own]) => own === name))
    const answer = ask('resonance', [...others, ['frequencies', '1:5:21'], ...methods.map((each): [string, string] => ['method', each]), ...options])
    if (answer.status !== 0) throw new Error(JSON.stringify(answer))
    return answer.document.curves
  }
  const swing = (curve: ResonanceCurve, at: number): number => curve.amplitude[curve.frequency.findIndex((each) => Math.abs(each - at) < 1e-9)]!

  it('of a linear law is the same stepped as in closed form', () => {
    const [exact, stepped] = curves(['exact', 'dormand-prince'], [['damping', '0.2']])
    expect(stepped!.frequency).toEqual(exact!.frequency)
    for (const [i, amplitude] of exact!.amplitude.entries()) {
      expect(stepped!.amplitude[i]! / amplitude).toBeCloseTo(1, 3)
      expect(stepped!.phase[i]! - exact!.phase[i]!).toBeCloseTo(0, 2)
    }
  })

  it('is known at the drive, wherever its points and its peak are', () => {
    for (const [damping, w] of [[0.2, 2.9371], [6, 2]] as const) {
      const [exact, stepped] = curves(['exact', 'dormand-prince'], [['damping', String(damping)], ['drive-frequency', String(w)]])
      const amplitude = 1 / Math.hypot(9 - w * w, damping * w)
      expect(exact!.at_drive! / amplitude).toBeCloseTo(1, 12)
      expect(stepped!.at_drive! / amplitude).toBeCloseTo(1, 3)
    }
    expect(curves(['forward-euler'], [['damping', '0.01']])[0]!.at_drive).toBeNull()
  })

  it('of dry friction is Den Hartog’s where it slides throughout', () => {
    // X = (F/k) sqrt(V^2 - (4f/pi F)^2) by the describing function, within a few percent above resonance
    const [curve] = curves(['dormand-prince'], [['damping', '0.05'], ['friction', '0.1']])
    const [w, f] = [3.4, 0.1]
    const [spring, damper] = [9 - w * w, 0.05 * w]
    // X with F = |spring X + i (damper X + 4f/pi)|
    let [low, high] = [0, 10]
    for (let i = 0; i < 60; ++i) {
      const x = (low + high) / 2
      if (Math.hypot(spring * x, damper * x + (4 * f) / Math.PI) < 1) low = x
      else high = x
    }
    expect(swing(curve!, w) / low).toBeCloseTo(1, 1.7)
  })

  it('of quadratic drag is that of harmonic balance, as each method has it', () => {
    const [curve, forward, implicit] = curves(['dormand-prince', 'forward-euler', 'implicit-euler'], [['drag', '0.2']])
    // at w0 the drag alone balances the force: F = 8/(3 pi) d w^2 X^2
    expect(swing(curve!, 3)).toBeCloseTo(Math.sqrt((3 * Math.PI) / (8 * 0.2 * 9)), 2)
    expect(swing(forward!, 3)).toBeGreaterThan(swing(curve!, 3))
    expect(swing(implicit!, 3)).toBeLessThan(swing(curve!, 3))
  })

  it('is not begun where it takes too many steps, and goes by the form of the law else', () => {
    const [tiny] = curves(['euler-cromer'], [['drag', '0.2'], ['step', '1e-6']])
    expect(tiny).toMatchObject({ settled: false, too_many_steps: true })
    const [growing] = curves(['forward-euler'], [['damping', '0.01']])
    expect(growing).toMatchObject({ settled: false, too_many_steps: false })
  })

  it('needs a drive', () => {
    expect(ask('resonance', [['step', '0.01']])).toMatchObject({ status: 2, document: { message: { en: 'drive amplitude: nothing drives it', de: 'drive amplitude: nichts treibt den Schwinger an' } } })
  })

  it('stands beside what the linear part of the law is known by', () => {
    const answer = ask('motion', [['mass', '2'], ['stiffness', '8'], ['damping', '0.4'], ['step', '0.01'], ['until', '0.01']])
    if (answer.status === 2) throw new Error(english(answer.document.message))
    const part = answer.document.linear_part
    expect(part).toMatchObject({ natural_frequency: 2, decay_rate: 0.1, critical_damping: 8, damping_ratio: 0.05, quality_factor: 10 })
    expect(part.damped_frequency).toBeCloseTo(Math.sqrt(3.99), 14)
    expect(part.resonance_frequency).toBeCloseTo(Math.sqrt(3.98), 14)
    expect(part.energy_factor_per_cycle).toBeCloseTo(Math.exp((-2 * Math.PI * 0.2) / Math.sqrt(3.99)), 14)
    const creeping = ask('motion', [['stiffness', '-1'], ['step', '0.01'], ['until', '0.01'], ['method', 'euler-cromer']])
    if (creeping.status === 2) throw new Error(english(creeping.document.message))
    expect(creeping.document.linear_part).toMatchObject({ natural_frequency: 0, critical_damping: 0, damping_ratio: null, energy_factor_per_cycle: 0 })
  })
})
