import { describe, expect, it } from 'vitest'
import type { Fit } from '../../src/core/types'
import { rowsOf } from '../../src/measure/rows'
import { storyOf } from '../../src/measure/story'
import { measure as en } from '../../src/words/en/measure'

const interval = (value: number, error: number): [number, number] => [value - 1.96 * error, value + 1.96 * error]
const piece = (amplitude: number, rate: number, standard_error = 0.0005) =>
  ({ amplitude, rate, standard_error, confidence_95: interval(rate, standard_error), law_rate: rate, from: 0, to: 1 })
const estimate = (value: number, standard_error: number, unit: string) =>
  ({ value, standard_error, confidence_95: interval(value, standard_error), unit })

function fit(change: Partial<Fit>): Fit {
  return {
    law: 'viscous+drag',
    coefficients: ['stiffness', 'damping'],
    residual: { rms: 0.0003, normality: 1, autocorrelation: 0, white: true },
    displacement_rms: 0.0003,
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
  it('does not take noise for a fall', () => {
    const pieces = [piece(0.03, 0.0101), piece(0.02, 0.01), piece(0.01, 0.0097)]
    const parameters = { decay_rate: estimate(0.01, 0.0002, '1/s') } as unknown as Fit['parameters']
    expect(said({ law: 'viscous', decay_by_amplitude: pieces, parameters })).toEqual([
      'One decay rate is enough. At every amplitude it is 0.01000\u00a0±\u00a00.00020\u00a01/s within its uncertainty.'
    ])
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
      derived: { quality_factor: estimate(88500, 177000, '1') }
    } as unknown as Partial<Fit>
    // 8.85 / (2 · 0.000246)
    expect(rowsOf(fit(change), en).find((row) => row.key === 'quality_factor')).toMatchObject({ value: 'above 17988', interval: '–' })
  })
})
