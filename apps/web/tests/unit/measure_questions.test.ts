import { describe, expect, it } from 'vitest'
import { equationOf } from '../../src/measure/laws'
import { commandLine, compareOptions, fitOptions, modesOptions, quoted } from '../../src/measure/questions'
import { measureDefaults } from '../../src/measure/state'

const lab = { ...measureDefaults, mass: '217,6 ± 0,3 g', disc: '12 cm', from: '4', to: '124' }

describe('questions', () => {
  it('carry only what was given, with decimal points', () => {
    expect(fitOptions(measureDefaults)).toEqual([])
    expect(fitOptions(lab)).toEqual([
      ['from', '4'],
      ['to', '124'],
      ['mass', '217.6 ± 0.3 g'],
      ['disc-diameter', '12 cm'],
      ['temperature', '20 °C']
    ])
  })
  it('name the run only where there are several', () => {
    expect(fitOptions({ ...measureDefaults, run: 2 }, 1)).toEqual([])
    expect(fitOptions({ ...measureDefaults, run: 2 }, 3)).toEqual([['run', '2']])
  })
  it('compare without what only a fit uses', () => {
    const names = compareOptions(lab, 1, 'viscous+drag').map(([name]) => name)
    expect(names).toEqual(['from', 'to', 'law', 'mass', 'method', 'method'])
  })
  it('ask for the modes of all columns, whatever the law', () => {
    const state = { ...lab, column: 'x', run: 2, rate: '50', skip: true, law: 'viscous', drive: 'auto' }
    expect(modesOptions(state)).toEqual([['rate', '50'], ['skip-bad-rows', 'true'], ['from', '4'], ['to', '124']])
    expect(modesOptions(state, 2)).toContainEqual(['run', '2'])
  })
})

describe('the command line', () => {
  it('asks the program the same', () => {
    expect(commandLine('fit', 'disc 12.csv', lab)).toBe(
      'cromer fit "disc 12.csv" --from 4 --to 124 --mass "217.6 ± 0.3 g" --disc-diameter "12 cm"'
    )
    expect(commandLine('modes', 'two carts.csv', { ...lab, column: 'x', skip: true })).toBe('cromer modes "two carts.csv" --skip-bad-rows --from 4 --to 124')
    expect(commandLine('fit', 'a.csv', { ...lab, air: '25 °C' })).toContain('--temperature "25 °C"')
    expect(commandLine('compare', 'a.csv', lab)).toBe('cromer compare a.csv --from 4 --to 124 --mass "217.6 ± 0.3 g" --disc-diameter "12 cm" --method forward-euler --method euler-cromer')
  })
  it('is safe in a shell', () => {
    expect(quoted('$(rm).csv')).toBe("'$(rm).csv'")
    expect(quoted("it's $5")).toBe(`'it'\\''s $5'`)
    expect(commandLine('fit', '-x.csv', measureDefaults)).toBe('cromer fit ./-x.csv')
    expect(commandLine('report', '-x.csv', measureDefaults)).toBe('cromer report ./-x.csv -o report')
  })
})

describe('the equation', () => {
  const text = (formulas: string[], driven = false) => equationOf(formulas, driven).map((part) => part.text).join('').replaceAll('\u00a0', ' ')
  it('has the terms of the law, those with the velocity first', () => {
    expect(text(['k x', "c x'", "d x'|x'|"])).toBe('m x″ + c x′ + d x′|x′| + k x = 0')
    expect(text(['k x', "f sgn(x')"])).toBe('m x″ + f sgn(x′) + k x = 0')
    expect(text(['k x', "c x'"], true)).toBe('m x″ + c x′ + k x = F cos ωt')
    expect(text(['k x', "c x'", 'k3 x^3'])).toBe('m x″ + c x′ + k x + k₃ x³ = 0')
    expect(text(["c x'", 'k2 x^2', 'ka x|x|', 'k5 x^5', "e x^2 x'", 'p sin x'])).toBe('m x″ + c x′ + e x² x′ + k₂ x² + kₐ x|x| + k₅ x⁵ + p sin x = 0')
    expect(text(['k x', "z, z' = A x' - beta |x'| z - gamma x'|z|"])).toBe('m x″ + k x + z = 0, z′ = A x′ − β |x′| z − γ x′|z|')
  })
  it('has variables in italics, functions and numbers upright', () => {
    expect(equationOf(['p sin x']).filter((part) => part.italic).map((part) => part.text)).toEqual(['m', 'x', 'p', 'x'])
  })
})
