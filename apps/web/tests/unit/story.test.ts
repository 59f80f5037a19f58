import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { read, start } from '../../src/core/core'
import type { Fit } from '../../src/core/types'
import { rowsOf } from '../../src/measure/rows'
import { storyOf } from '../../src/measure/story'
import { numbersOf } from '../../src/teach/seed'
import { measure as en } from '../../src/words/en/measure'

const interval = (value: number, error: number): [number, number] => [value - 1.96 * error, value + 1.96 * error]
const piece = (amplitude: number, rate: number, standard_error = 0.0005) =>
  ({ amplitude, rate, standard_error, confidence_95: interval(rate, standard_error), law_rate: rate, angular_frequency: 20, angular_frequency_standard_error: 0.001, law_angular_frequency: 20, from: 0, to: 1 })
const estimate = (value: number, standard_error: number, unit: string) =>
  ({ value, standard_error, confidence_95: interval(value, standard_error), unit })

function fit(change: Partial<Fit>): Fit {
  return {
    law: 'viscous+drag',
    coefficients: ['stiffness', 'damping'],
    residual: { rms: 0.0003, normality: 1, autocorrelation: 0, white: true },
    displacement_rms: 0.0003,
    units: { displacement: 'm' },
    parameters: { stiffness: estimate(17.04, 0.0235, 'N/m'), damping: estimate(0.000785, 0.0000182, 'kg/s') },
    derived: { frequency: estimate(1.40839883, 9.35e-7, 'Hz') },
    decay_by_amplitude: [piece(0.034, 0.0139), piece(0.02, 0.009), piece(0.012, 0.0067)],
    stiffness_budget: [],
    reynolds: null,
    notices: [],
    ...change
  } as unknown as Fit
}
const said = (change: Partial<Fit>) => storyOf(fit(change), en).map(({ title, text }) => `${title} ${text}`)

describe('the story', () => {
  it('says that one rate is not enough, with its numbers', () => {
    expect(said({})).toEqual([
      'One decay rate is not enough. It falls from 0.0139 to 0.00670 1/s as the swing dies down; quote the law instead.'
    ])
  })
  it('says where the rate rises', () => {
    const pieces = [piece(0.05, 0.1), piece(0.03, 0.2), piece(0.01, 0.4)]
    expect(said({ law: 'friction', decay_by_amplitude: pieces })[0]).toContain('rises from 0.100 to 0.400')
  })
  it('quotes no law that the core doubts, or whose rate goes the other way', () => {
    const text = { en: 'no law tried describes this recording', de: '' }
    expect(said({ notices: [{ code: 'no_law_describes', severity: 'wrong_if_ignored', text, values: {} }] })).toEqual([
      'The core says no law tried describes this recording'
    ])
    const beats = [piece(0.034, 0.0591), piece(0.02, 0.09), piece(0.012, 0.113)].map((each, i) => ({ ...each, law_rate: [0.113, 0.09, 0.0591][i]! }))
    expect(said({ decay_by_amplitude: beats })).toEqual([])
  })
  it('does not take noise for a fall, and says how far the rate is known to stay', () => {
    const known = [piece(0.03, 0.1004), piece(0.02, 0.1), piece(0.01, 0.0996)]
    // change 0.0008, its standard error 0.0005·√2: a bound of 2.2 % of 0.1
    expect(said({ law: 'viscous', decay_by_amplitude: known })).toEqual([
      'One decay rate is enough. Between the amplitudes 3.0\u00a0cm and 1.0\u00a0cm it changes by at most 2.3\u00a0% (95\u00a0%).'
    ])
    const unknown = [piece(0.03, 0.0101), piece(0.02, 0.01), piece(0.01, 0.0097)]
    expect(said({ law: 'viscous', decay_by_amplitude: unknown })).toEqual([
      'No change of the decay rate is seen. Between the amplitudes 3.0\u00a0cm and 1.0\u00a0cm it may still change by up to 19\u00a0%; a longer or larger swing would tell.'
    ])
  })
  it('sees a change that all pieces show together and the ends alone do not', () => {
    const pieces = [0.0112, 0.0108, 0.0104, 0.01, 0.0096, 0.0092, 0.0088].map((rate, i) => piece(0.03 - 0.003 * i, rate, 0.0006))
    expect(said({ law: 'viscous', decay_by_amplitude: pieces })[0]).toContain('falls from 0.0112 to 0.00880')
  })
  it('says nothing of two pieces', () => {
    expect(said({ law: 'viscous', decay_by_amplitude: [piece(0.03, 0.1), piece(0.02, 0.1)] })).toEqual([])
  })
  it('leaves out pieces that are all noise', () => {
    const pieces = [piece(0.05, 0.1, 0.001), piece(0.04, 0.1, 0.001), piece(0.03, 0.1, 0.001), piece(0.0004, 300, 90)]
    expect(said({ law: 'friction', decay_by_amplitude: pieces })).toEqual([])
  })
  it('holds pieces against the noise as a displacement, whatever was recorded', () => {
    // A swing of 1 mm at 20 rad/s is 0.4 m/s²; a noise of 0.02 m/s² is 0.05 mm of it.
    const pieces = [piece(0.001, 0.1), piece(0.0007, 0.08), piece(0.0004, 0.06)]
    const residual = { rms: 0.02, normality: 1, autocorrelation: 0, white: true }
    expect(said({ decay_by_amplitude: pieces, residual, displacement_rms: 0.02 / 20 ** 2 })[0]).toContain('falls from')
  })
  it('does not name a rest that is nothing', () => {
    const budget = [{ quantity: 'mass', standard_uncertainty: 0.0003, share: 0.999999 }] as unknown as Fit['stiffness_budget']
    expect(said({ stiffness_budget: budget })[1]).toBe(
      'The mass limits k. Of its ± 0.024\u00a0N/m, the balance causes practically all.'
    )
  })
  it('names what limits k', () => {
    const budget = [{ quantity: 'mass', standard_uncertainty: 0.0003, share: 0.99 }] as unknown as Fit['stiffness_budget']
    expect(said({ stiffness_budget: budget })[1]).toBe(
      'The mass limits k. Of its ± 0.024\u00a0N/m, the balance causes all but 1.0\u00a0%.'
    )
  })
})

/// A swing under viscous damping and weak drag in closed form, by the slow change of its amplitude, with noise from `seed`.
function weakDrag(seed: number, drag: number, seconds: number) {
  const [rate, amplitude, w, noise] = [0.01, 0.004, 9, 1.5e-4]
  const perAmplitude = (4 * drag * w) / (3 * Math.PI)
  const next = numbersOf(seed)
  const gauss = () => Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next())
  const rows = Array.from({ length: seconds * 50 }, (_, i) => {
    const left = Math.exp((-rate * i) / 50)
    const now = (amplitude * rate * left) / (rate + perAmplitude * amplitude * (1 - left))
    return `${i / 50},${0.2 + now * Math.cos((w * i) / 50) + noise * gauss()}`
  })
  return { text: `t (s),x (m)\n${rows.join('\n')}\n`, rateAt: (size: number) => rate + perAmplitude * size }
}
const core = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))

// ./dev page builds the core.
describe.skipIf(!existsSync(core))('the story of a recording whose law is known', () => {
  it.each([[0, 300], [0.5, 30], [0.5, 100], [2, 30], [2, 100]])('is true of a drag per mass of %s 1/m in %s s', { timeout: 60_000 }, async (drag, seconds) => {
    const opened = await start(await WebAssembly.compile(readFileSync(core)))
    for (const seed of [1, 2, 3, 4, 5, 6, 7, 8]) {
      const { text, rateAt } = weakDrag(seed, drag, seconds)
      const answer = read<'fit'>(opened.answer('fit', [['law', 'viscous']], new TextEncoder().encode(text)))
      if (answer.status === 2) throw new Error('refused')
      const fitted = answer.document.fits[0]!
      const [first] = storyOf(fitted, en)
      const [, from, to, part] = first?.text.match(/amplitudes ([\d.]+)\u00a0mm and ([\d.]+)\u00a0mm .* ([\d.]+)\u00a0%/) ?? []
      if (first?.title === en.story.notEnough) expect(drag, text).toBeGreaterThan(0)
      else if (from) {
        const [most, least] = [rateAt(Number(from) / 1000), rateAt(Number(to) / 1000)]
        expect((2 * (most - least)) / (most + least), `seed ${seed}: ${first!.title} ${first!.text}`).toBeLessThan(Number(part) / 100)
      }
      else throw new Error(`seed ${seed}: ${first?.text}`)
    }
  })
})

describe('the table of the law', () => {
  it('has values with their uncertainties and intervals', () => {
    const rows = rowsOf(fit({}), en)
    expect(rows.map((row) => row.key)).toEqual(['stiffness', 'damping', 'frequency'])
    expect(rows[0]).toMatchObject({ value: '17.040\u00a0±\u00a00.024\u00a0N/m', interval: '16.99\u00a0to 17.09' })
    expect(rows[1]!.value).toBe('0.785\u00a0±\u00a00.018\u00a0g/s')
    expect(rows[2]!.value).toBe('1.408\u202f398\u202f8(9)\u00a0Hz')
  })
  it('writes both ends of an interval in full', () => {
    expect(rowsOf(fit({}), en)[2]!.interval).toBe('1.408\u202f397\u202f0\u00a0to 1.408\u202f400\u202f7')
  })
  it('shows the coefficients that the core names, in its order', () => {
    const parameters = { angular_frequency: estimate(8.85, 1e-5, 'rad/s'), drag: estimate(0.09, 0.001, '1/m'), decay_rate: estimate(0.01, 0.001, '1/s') } as unknown as Fit['parameters']
    expect(rowsOf(fit({ coefficients: ['drag', 'angular_frequency'], parameters }), en).map((row) => row.key)).toEqual(['drag', 'angular_frequency', 'frequency'])
  })
  it('keeps the digits of an interval that is cut where the quantity ends', () => {
    const cut = { ...estimate(0.00002, 0.00005, 'kg/s'), confidence_95: [0, 0.000118] }
    const parameters = { stiffness: estimate(17.04, 0.0235, 'N/m'), damping: cut } as unknown as Fit['parameters']
    expect(rowsOf(fit({ parameters }), en)[1]!.interval).toBe('0.00\u00a0to 0.12')
  })
  it('gives the lower end alone of a quality factor whose rate may be 0', () => {
    const change = {
      law: 'viscous',
      parameters: { decay_rate: { ...estimate(0.00005, 0.0001, '1/s'), confidence_95: [0, 0.000246] }, angular_frequency: estimate(8.85, 1e-5, 'rad/s') },
      derived: { quality_factor: { ...estimate(88500, 177000, '1'), confidence_95: [17988, null] } }
    } as unknown as Partial<Fit>
    expect(rowsOf(fit(change), en).find((row) => row.key === 'quality_factor')).toMatchObject({ value: 'above 17988', interval: '–' })
  })
})
