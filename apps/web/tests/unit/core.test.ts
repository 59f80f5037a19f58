import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { buffersOf, withBlocks } from '../../src/core/blocks'
import { open } from '../../src/core/core'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm.gz', import.meta.url))

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
    expect(buffersOf(document)).toHaveLength(2)
  })
})

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('core', async () => {
  const core = existsSync(built) ? await open(readFileSync(built)) : undefined!

  it('simulates', () => {
    const answer = core.answer('simulate', [
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

  const swing = (heading: string, times: number, amplitude: number) =>
    heading +
    '\n' +
    Array.from({ length: 800 }, (_, i) => {
      const at = i / 100
      return `${(at * times).toPrecision(12)},${amplitude * Math.exp(-0.1 * at) * Math.cos(10 * at)}\n`
    }).join('')
  const inspected = (text: string, options: [string, string][] = []) => {
    const answer = core.answer('inspect', options, new TextEncoder().encode(text))
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
    const answer = core.answer('fit', [['law', 'viscous']], new TextEncoder().encode(text))
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
    expect(core.answer('simulate', [['step', '-1']])).toEqual({
      status: 2,
      document: { message: '--step: it must be positive, not -1 s' },
    })
  })

  it('asks for less where its memory ends, and goes on', () => {
    const answer = core.answer('simulate', [
      ['step', '1e-9'],
      ['until', '10'],
    ])
    expect(answer.status).toBe(2)
    expect(core.answer('effective', []).status).toBe(0)
  })
})
