import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { withBlocks } from '../../src/core/blocks'
import { read, start } from '../../src/core/core'
import type { Options, Task } from '../../src/core/types'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

describe('blocks', () => {
  it('come back into their places', () => {
    const numbers = new Float64Array([1, 2, 3, 4])
    const document = withBlocks(
      { a: { block: [1, 2] }, list: [{ block: [0, 1] }, null], text: 'block' },
      numbers,
    )
    expect(document).toEqual({
      a: new Float64Array([2, 3]),
      list: [new Float64Array([1]), null],
      text: 'block',
    })
  })
})

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('core', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  const ask = <T extends Task>(task: T, options: Options, file?: Uint8Array) => read<T>(core.answer(task, options, file))

  it('simulates', () => {
    const answer = ask('simulate', [
      ['stiffness', '4 N/m'],
      ['method', 'exact'],
      ['step', '10 ms'],
      ['until', '1 s'],
    ])
    if (answer.status !== 0) throw new Error(JSON.stringify(answer))
    const { t, x } = answer.document.runs[0]!.states
    expect(t).toHaveLength(101)
    expect(x[100]).toBeCloseTo(Math.cos(2), 12)
  })

  it('gives the motions of a simulation without the rest of its document', () => {
    const options: Options = [
      ['stiffness', '4'],
      ['damping', '0.1'],
      ['method', 'exact'],
      ['method', 'forward-euler'],
      ['step', '1'],
      ['until', '2000'],
    ]
    const [whole, motions] = [ask('simulate', options), ask('motion', options)]
    if (whole.status === 2 || motions.status === 2) throw new Error('refused')
    expect(motions.document.runs.map((run) => run.states)).toEqual(whole.document.runs.map((run) => run.states))
    // the second ends where it left the numbers, with the same times so far
    const [first, second] = motions.document.runs
    expect(second!.status).toBe('not_finite')
    expect(second!.states.t.length).toBeLessThan(first!.states.t.length)
    expect(second!.states.t.byteOffset).toBe(first!.states.t.byteOffset)
    motions.document.runs.forEach((run, i) => {
      const { parameters, final, ...others } = whole.document.runs[i]!
      expect(run).toMatchObject({ drive_frequency: parameters.drive_frequency, energy_at_end: final.energy })
      for (const name of ['method', 'step', 'until', 'effective', 'stable', 'stability_limit', 'energy_factor_per_cycle'] as const)
        expect(run[name]).toEqual(others[name])
    })
  })

  const swing = (heading: string, times: number, amplitude: number) =>
    heading +
    '\n' +
    Array.from({ length: 800 }, (_, i) => {
      const at = i / 100
      return `${(at * times).toPrecision(12)},${amplitude * Math.exp(-0.1 * at) * Math.cos(10 * at)}\n`
    }).join('')
  const inspected = (text: string, options: [string, string][] = []) => {
    const answer = ask('inspect', options, new TextEncoder().encode(text))
    if (answer.status !== 0) throw new Error(JSON.stringify(answer))
    return answer.document
  }

  it.each([
    ['us', 1e6], ['µs', 1e6], ['ms', 1e3], ['min', 1 / 60], ['h', 1 / 3600],
  ])('has the times of a file in %s in seconds', (unit, times) => {
    const [series] = inspected(swing(`Time (${unit}),Position (mm)`, times, 30)).series
    expect(series!.t[799]).toBeCloseTo(7.99, 9)
    expect(series!.x[0]).toBeCloseTo(0.03, 12)
    expect(series!.rate).toBeCloseTo(100, 6)
    expect(series!.unit).toBe('m')
  })

  it.each([
    ['Acceleration (g)', 9.80665, 'm/s²', 'm', 'm/s'],
    ['Gyroscope x (deg/s)', Math.PI / 180, 'rad/s', 'rad', 'rad/s'],
    ['Velocity (cm/s)', 0.01, 'm/s', 'm', 'm/s'],
    ['Velocity (in/s)', 0.0254, 'm/s', 'm', 'm/s'],
    ['Angle (°)', Math.PI / 180, 'rad', 'rad', 'rad/s'],
  ])('says the units of %s', (column, factor, measured, displacement, velocity) => {
    const text = swing(`Time (s),${column}`, 1, 0.3)
    const { series } = inspected(text)
    expect(series[0]!.unit).toBe(measured)
    expect(series[0]!.x[0]).toBeCloseTo(0.3 * factor, 12)
    const answer = ask('fit', [['law', 'viscous']], new TextEncoder().encode(text))
    if (answer.status !== 0) throw new Error(JSON.stringify(answer))
    const fit = answer.document.fits[0]!
    expect(fit.units).toMatchObject({ measured, displacement, velocity })
    expect(fit.curves!.measured[0]).toBeCloseTo(0.3 * factor, 12)
    const order = measured === displacement ? 0 : measured === velocity ? 1 : 2
    expect(fit.displacement_rms! / fit.residual.rms!).toBeCloseTo(10 ** -order, 5)
    for (const { rate, standard_error, confidence_95 } of fit.decay_by_amplitude)
      expect(confidence_95[1]! - rate!).toBeGreaterThan(1.9 * standard_error!)
  })

  it('names the column it takes, and takes another', () => {
    const text = 'Time (s),Position x (cm),Position y (cm)\n' +
      Array.from({ length: 50 }, (_, i) => `${i / 10},${i % 7},${i % 5}\n`).join('')
    expect(inspected(text).column).toBe('Position x (cm)')
    const other = inspected(text, [['column', 'Position y (cm)']])
    expect(other.column).toBe('Position y (cm)')
    expect(other.series[0]!.x[4]).toBeCloseTo(0.04, 12)
  })

  it('says what is wrong as the program does', () => {
    expect(ask('simulate', [['step', '-1']])).toMatchObject({
      status: 2,
      document: { message: { en: 'step: it must be positive, not -1 s', de: 'step: das muss größer als 0 sein: -1 s geht nicht' }, argument: 'step' },
    })
  })

  it('reads a quantity, and runs nothing for it', () => {
    expect(ask('quantity', [['step', '20 ms']])).toEqual({ status: 0, document: { step: 0.02 } })
    expect(ask('quantity', [['stiffness', '1e25 N/m']])).toEqual({ status: 0, document: { stiffness: 1e25 } })
    expect(ask('quantity', [['drive-frequency', '1 Hz']]).document).toEqual({ 'drive-frequency': 2 * Math.PI })
    expect(ask('quantity', [['mass', '-1']])).toMatchObject({ status: 2, document: { message: { en: 'mass: it must be positive, not -1 kg', de: 'mass: das muss größer als 0 sein: -1 kg geht nicht' }, argument: 'mass' } })
    expect(ask('quantity', [['stiffness', '2,500']])).toMatchObject({ status: 2 })
  })

  it('knows velocity and energy of a recording, its law and a method', () => {
    const [k, m, amplitude, gamma] = [17, 0.2, 0.03, 0.02]
    const omega = Math.sqrt(k / m - gamma ** 2)
    const t = Array.from({ length: 2000 }, (_, i) => i / 100)
    const x = t.map((at) => amplitude * Math.exp(-gamma * at) * Math.cos(omega * at))
    const text = `Time (s),Position (m)\n${t.map((at, i) => `${at},${0.2 + x[i]!}`).join('\n')}\n`
    const file = new TextEncoder().encode(text)
    const options: [string, string][] = [['file-name', 'x.csv'], ['law', 'viscous'], ['mass', '0.2 kg']]
    const fitted = ask('fit', options, file)
    if (fitted.status !== 0) throw new Error(JSON.stringify(fitted))
    const curves = fitted.document.fits[0]!.curves!
    for (const i of [200, 777, 1500]) {
      const decay = Math.exp(-gamma * t[i]!)
      const v = -amplitude * decay * (gamma * Math.cos(omega * t[i]!) + omega * Math.sin(omega * t[i]!))
      const energy = 0.5 * m * v ** 2 + 0.5 * k * x[i]! ** 2
      expect(Math.abs(curves.v[i]! - v)).toBeLessThan(1e-6)
      expect(Math.abs(curves.measured_velocity[i]! - v)).toBeLessThan(0.003 * omega * amplitude)
      expect(curves.energy[i]! / energy).toBeCloseTo(1, 6)
      expect(curves.measured_energy[i]! / energy).toBeCloseTo(1, 2)
    }
    expect(curves.measured_velocity[0]).toBeNaN()
    const compared = ask('compare', [...options, ['method', 'forward-euler']], file)
    if (compared.status === 2) throw new Error(JSON.stringify(compared))
    const { energy, x: place, v } = compared.document.comparisons[0]!.states.at(-1)!
    expect(energy[0]! / curves.energy[0]!).toBeCloseTo(1, 9)
    expect(energy[50]).toBeCloseTo(0.5 * m * v[50]! ** 2 + 0.5 * k * place[50]! ** 2, 8)
  })

  it('asks for less where its memory ends, and goes on', () => {
    const answer = ask('simulate', [
      ['step', '1e-9'],
      ['until', '10'],
    ])
    expect(answer.status).toBe(2)
    expect(ask('effective', []).status).toBe(0)
  })
})
