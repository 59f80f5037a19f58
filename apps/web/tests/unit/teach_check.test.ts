import { existsSync, readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { read, start } from '../../src/core/core'
import type { Comparisons, Fits } from '../../src/core/types'
import { percent } from '../../src/look/numbers'
import { withUncertainty } from '../../src/measure/uncertain'
import { airViscosity } from '../../src/teach/air'
import { answerOf, check } from '../../src/teach/check'
import { keyOfOne } from '../../src/teach/key_one'
import { keyOfTwo as keyOf } from '../../src/teach/key_two'
import { tolerant } from '../../src/teach/options'
import { oscillatorOf } from '../../src/teach/own_oscillator'
import { questionsOf, type AskCore, type Expected } from '../../src/teach/questions'
import { seedOf } from '../../src/teach/seed'
import { teach as de } from '../../src/words/de/teach'
import { teach as en } from '../../src/words/en/teach'
import { massText, discText, recordingOptions, truthOf } from '../../src/teach/truth'

const expected: Expected = {
  value: 2532,
  unit: '',
  enough: 0,
  uncertainty: { least: 2.5, most: 380, within: 5 },
  slips: [{ name: 'radius', value: 1266 }]
}

describe('an answer', () => {
  it.each([
    ['', '', 'empty'],
    ['2535', '5', 'right'],
    ['2535', '1', 'tooSmall'],
    ['2600', '500', 'tooLarge'],
    ['2544', '4', 'right'],
    ['2545', '4', 'notYet'],
    ['2600', '5', 'notYet'],
    ['2535', '', 'noUncertainty'],
    ['2535', '0', 'noUncertainty'],
    ['abc', '1', 'noNumber']
  ])('%s ± %s is %s', (value, uncertainty, verdict) => {
    expect(check(value, uncertainty, expected).verdict).toBe(verdict)
  })
  it('says by how many of its own ± it is off', () => {
    expect(check('2536', '20', expected).off).toBeCloseTo(0.2, 12)
    expect(check('2500', '5', expected)).toMatchObject({ above: false, verdict: 'notYet' })
  })
  it('recognises a common slip', () => {
    expect(check('1270', '5', expected).slip).toBe('radius')
    expect(check('1500', '5', expected).slip).toBe('')
  })
  it('may be typed with its unit, and with its ± in one', () => {
    const stiffness: Expected = { value: 17.04, unit: 'N/m', enough: 0, uncertainty: { least: 0.02, most: 0.5, within: 0.04 }, slips: [] }
    for (const [value, uncertainty] of [['17,04 N/m', '0,03 N/m'], ['17.05', '0.03'], ['17.04\u00a0N/m', '0.03']])
      expect(check(value!, uncertainty!, stiffness).verdict, value).toBe('right')
    expect(check('17.04 N', '0.03', stiffness).verdict).toBe('noNumber')
    expect(check('-3.8 %', '0.3', { value: 3.8, unit: '%', unsigned: true, enough: 0, uncertainty: { least: 0.05, most: 2, within: 0.1 }, slips: [] }).verdict).toBe('right')
    expect(answerOf('1,408 ± 0,002 Hz', 'Hz')).toEqual({ value: '1,408', uncertainty: '0,002' })
    expect(answerOf('(17.04 +/- 0.03) N/m', 'N/m')).toEqual({ value: '17.04', uncertainty: '0.03' })
    expect(answerOf('1.408 398 8(9) Hz', 'Hz')).toEqual({ value: '1.408 398 8', uncertainty: '0.0000009' })
    expect(answerOf('2535(12)', '')).toEqual({ value: '2535', uncertainty: '12' })
    expect(answerOf('-3.8', '%')).toEqual({ value: '-3.8', uncertainty: null })
  })
  it('is right within a class’s tolerance, whatever its ±', () => {
    const near = tolerant(expected, { labs: ['two'], hideLaw: false, tolerance: 3, tasks: [] })
    expect(check('2600', '', near)).toMatchObject({ verdict: 'right', off: null, above: true })
    expect(check('2450', '1', near).verdict).toBe('notYet')
    expect(check('2450', '', near).verdict).toBe('noUncertainty')
  })
  it('needs no ± where none is asked for', () => {
    const plain: Expected = { ...expected, enough: 50, uncertainty: null }
    expect(check('2580', '', plain)).toMatchObject({ verdict: 'right', part: 48 / 2532 })
    expect(check('1270', '', plain)).toMatchObject({ verdict: 'notYet', slip: 'radius', off: null, above: false })
  })
  it('may be typed with a decimal comma', () => {
    expect(check('2535,5', '4,5', expected).verdict).toBe('right')
  })
})

/// The compiled core: what CROMER_WASM names, else the one of the build directory.
const core = [process.env.CROMER_WASM, '../../build/page/core.wasm'].find((file) => file && existsSync(file)) ?? ''

/// What a careful student gets with a ruler and a calculator: passages through the middle, peaks, their logarithms.
function byHand(text: string, mass: [value: number, error: number], disc: number) {
  const rows = text.trim().split('\n').slice(1).map((line) => line.split(',').map(Number) as [number, number])
  const rest = rows.reduce((sum, [, x]) => sum + x, 0) / rows.length
  // of a passage the middle of the samples near it, so that noise does not count it twice
  const passages: number[] = []
  for (let i = 8; i < rows.length - 8; ++i) {
    const at = (j: number) => rows[j]![1] - rest
    const slope = at(i + 8) - at(i - 8)
    if (at(i - 1) < 0 && at(i) >= 0 && slope > 0 && (passages.length === 0 || rows[i]![0] - passages.at(-1)! > 0.3))
      passages.push(rows[i - 1]![0] + (0.01 * -at(i - 1)) / (at(i) - at(i - 1)))
  }
  const [count, span] = [passages.length - 1, passages.at(-1)! - passages[0]!]
  const frequency: [number, number] = [count / span, ((count / span) * 0.01) / span]
  const stiffness = (2 * Math.PI * frequency[0]) ** 2 * mass[0]
  const peaks = passages.slice(0, -1).map((from, i) => {
    const inside = rows.filter(([t]) => t >= from && t < passages[i + 1]!)
    const high = inside.reduce((best, row) => (row[1] > best[1] ? row : best))
    const near = inside.filter(([t]) => Math.abs(t - high[0]) <= 0.045) // a parabola's worth, read with the eye
    const w = 2 * Math.PI * frequency[0]
    const mean = near.reduce((sum, [t, x]) => sum + (x - rest) / Math.cos(w * (t - high[0])), 0) / near.length
    return [high[0], mean] as const
  })
  const part = peaks.filter(([t]) => t >= 30 && t <= 60).map(([t, a]) => [t, Math.log(a)] as const)
  const mid = part.reduce((sum, [t]) => sum + t, 0) / part.length
  const level = part.reduce((sum, [, l]) => sum + l, 0) / part.length
  const spread = part.reduce((sum, [t]) => sum + (t - mid) ** 2, 0)
  const slope = part.reduce((sum, [t, l]) => sum + (t - mid) * (l - level), 0) / spread
  const left = Math.sqrt(part.reduce((sum, [t, l]) => sum + (l - level - slope * (t - mid)) ** 2, 0) / (part.length - 2) / spread)
  const reynolds = (2 * Math.PI * frequency[0] * peaks[0]![1] * disc) / airViscosity
  return {
    frequency,
    stiffness: [stiffness, stiffness * Math.hypot(mass[1] / mass[0], (2 * frequency[1]) / frequency[0])] as [number, number],
    rate: [-slope, left] as [number, number],
    reynolds: [reynolds, 0.02 * reynolds] as [number, number],
  }
}

/// Some of a class of two hundred; all of them, which takes half an hour, or those that CROMER_CLASS names: "all", "3,6".
/// Careful hands of 3 and 59 are off by more than twice their own ±.
const named = process.env.CROMER_CLASS ?? '1,3,59,200'
const students = named === 'all' ? Array.from({ length: 200 }, (_, i) => i + 1) : named.split(',').map(Number)
const recordings = [['7F3A', '19'], ['practice', '1'], ['C', '4'], ['C', '11'], ...students.map((number) => ['CLASS', String(number)])] as [string, string][]

/// What a student gets with a pencil: the formulas of the lab, none of the small corrections.
function withPencil({ mass, stiffness, damping, force, step }: ReturnType<typeof oscillatorOf>) {
  const w = Math.sqrt(stiffness / mass)
  const steps = (2 * Math.PI) / w / step
  return {
    resonance: w,
    amplitude: force / (damping * w),
    forwardLimit: damping / stiffness,
    cromerLimit: 2 / w,
    growth: (1 + (w * step) ** 2) ** steps,
    simulatedRate: damping / (2 * mass) + (w * w * step) / 2,
  }
}

describe.skipIf(!core)('the key of lab one (skipped where the core is not built)', () => {
  it('is what a pencil finds, and names its slips, of 200 students', async () => {
    const opened = await start(await WebAssembly.compile(readFileSync(core)))
    const ask: AskCore = async (task, options, asking) => read(opened.answer(task, options, asking?.file))
    const seen = new Set<string>()
    for (let number = 1; number <= 200; ++number) {
      const oscillator = oscillatorOf(seedOf('CLASS', String(number)))
      seen.add(JSON.stringify(oscillator))
      const key = (await keyOfOne(oscillator, ask))!
      const found = withPencil(oscillator)
      for (const question of questionsOf.one) {
        const typed = found[question].toPrecision(3)
        expect([number, question, typed, check(typed, '', key[question]).verdict]).toEqual([number, question, typed, 'right'])
        // far enough off to be told from a right one
        expect(check(String(1.05 * key[question].value), '', key[question]).verdict).toBe('notYet')
      }
      const { mass, stiffness, damping, force } = oscillator
      expect(check(String(found.resonance / (2 * Math.PI)), '', key.resonance).slip).toBe('hertz')
      expect(check(String(force / stiffness), '', key.amplitude).slip).toBe('static')
      expect(check(String(2 / found.resonance), '', key.forwardLimit).slip).toBe('cromersOwn')
      expect(check(String(Math.sqrt(found.growth)), '', key.growth).slip).toBe('ofAmplitude')
      expect(check(String(damping / (2 * mass)), '', key.simulatedRate).slip).toBe('asked')
    }
    expect(seen.size).toBe(200)
  })
})

describe.skipIf(!core)('the key of a recording (skipped where the core is not built)', () => {
  it('is what a careful student finds, and refuses a careless one', { timeout: 60_000 }, async () => {
    const opened = await start(await WebAssembly.compile(readFileSync(core)))
    const ask: AskCore = async (task, options, asking) =>
      read(opened.answer(task, asking?.fileName ? [...options, ['file-name', asking.fileName]] : options, asking?.file))
    const truth = truthOf(seedOf('7F3A', '19'))
    const key = (await keyOf(truth, ask))!
    expect(key.stiffness.value).toBe(truth.stiffness)
    expect(key.frequency.value).toBeCloseTo(Math.sqrt(truth.stiffness / truth.mass) / (2 * Math.PI), 5)

    const made = await ask('synthetic', recordingOptions(truth))
    const file = new TextEncoder().encode((made!.document as { text: string }).text)
    const fit = async (options: [string, string][]) =>
      ((await ask('fit', options, { file, fileName: 'own.csv' }))!.document as Fits).fits[0]!
    const lab: [string, string][] = [['mass', massText(truth)], ['disc-diameter', discText(truth)]]
    const own = await fit([['law', 'viscous+drag'], ...lab])
    const k = own.parameters.stiffness!
    expect(check(String(k.value), String(k.standard_error), key.stiffness).verdict).toBe('right')
    const re = own.reynolds!
    expect(check(String(re.max), String(0.002 * re.max), key.reynolds).verdict).toBe('right')
    const f = own.derived.frequency!
    expect(check(String(f.value), String(f.standard_error), key.frequency).verdict).toBe('right')
    const middle = (await fit([['law', 'viscous'], ['from', '30'], ['to', '60']])).parameters.decay_rate!
    expect(check(String(middle.value), String(middle.standard_error), key.rate).verdict).toBe('right')
    const early = (await fit([['law', 'viscous'], ['to', '30']])).parameters.decay_rate!
    expect(check(String(early.value), '0.0001', key.rate)).toMatchObject({ verdict: 'notYet', slip: 'first' })
  })

  it('asks for the Reynolds number with the viscosity of air that the core has', async () => {
    const opened = await start(await WebAssembly.compile(readFileSync(core)))
    const [amplitude, frequency, disc] = [0.03, 2, 0.1]
    // undamped: the largest speed is 2πfA, and is among the samples
    const made = read<'synthetic'>(opened.answer('synthetic', [
      ['mass', '1 kg'], ['stiffness', String((2 * Math.PI * frequency) ** 2)], ['position', `${amplitude} m`], ['until', '20 s'], ['method', 'exact'],
      ['step', '10 ms'], ['sensor-noise', '0.01 mm'], ['seed', '1'],
    ]))
    if (made.status === 2) throw new Error('refused')
    const fitted = read<'fit'>(opened.answer('fit', [['law', 'viscous'], ['disc-diameter', `${disc} m`]], new TextEncoder().encode(made.document.text)))
    if (fitted.status === 2) throw new Error('refused')
    const viscosity = (2 * Math.PI * frequency * amplitude * disc) / fitted.document.fits[0]!.reynolds!.max!
    expect(Math.abs(viscosity / airViscosity - 1)).toBeLessThan(3e-4)
    for (const [words, told] of [[en, '1.506'], [de, '1,506']] as const) {
      expect(words.two.map(({ byHand }) => byHand?.text ?? '').join()).toContain(`*ν* = ${told} · 10⁻⁵ m²/s`)
      expect(Number(told.replace(',', '.'))).toBe(Number((airViscosity * 1e5).toPrecision(9)))
    }
  })

  it.each(recordings)('calls right what the page itself says of recording %s-%s, and a careful hand', { timeout: 240_000 }, async (course, student) => {
    const opened = await start(await WebAssembly.compile(readFileSync(core)))
    const ask: AskCore = async (task, options, asking) =>
      read(opened.answer(task, asking?.fileName ? [...options, ['file-name', asking.fileName]] : options, asking?.file))
    const truth = truthOf(seedOf(course, student))
    const key = (await keyOf(truth, ask))!
    const made = await ask('synthetic', recordingOptions(truth))
    const text = (made!.document as { text: string }).text
    const asking = { file: new TextEncoder().encode(text), fileName: 'own.csv' }
    const lab: [string, string][] = [['mass', massText(truth)], ['disc-diameter', discText(truth)]]
    const fit = async (options: [string, string][]) => ((await ask('fit', [...options, ...lab], asking))!.document as Fits).fits[0]!
    const whole = await fit([['law', 'viscous+drag']])
    const middle = await fit([['law', 'viscous'], ['from', '30'], ['to', '60']])
    const compared = (await ask('compare', [['law', 'viscous+drag'], ...lab], asking))!.document as Comparisons
    const said = {
      frequency: whole.derived.frequency!,
      stiffness: whole.parameters.stiffness!,
      rate: middle.parameters.decay_rate!,
      reynolds: { value: whole.reynolds!.max, standard_error: whole.reynolds!.standard_error },
    }
    // as the page writes them, pasted into one field
    for (const question of ['frequency', 'stiffness', 'rate', 'reynolds'] as const) {
      const { value, standard_error } = said[question]
      const text = withUncertainty(value!, standard_error, key[question].unit)
      if (course === '7F3A' && question === 'reynolds') expect(text).toBe('2120.0\u00a0±\u00a00.9')
      const answer = answerOf(text, key[question].unit)
      expect([text, check(answer.value, answer.uncertainty!, key[question]).verdict]).toEqual([text, 'right'])
    }
    // the text's formula from true values, whatever its ±
    const formula = (2 * Math.PI * key.frequency.value * truth.start * truth.disc) / airViscosity
    for (const value of [Math.round(formula), formula]) expect(check(String(value), String(0.0005 * value), key.reynolds).verdict).toBe('right')
    const off = percent(compared.comparisons[0]!.curves[0]!.amplitude_ratio_end! - 1, 3)
    expect([off, check(off, '0.1', key.off).verdict]).toEqual([off, 'right'])
    const hand = byHand(text, [truth.massRead, truth.massUncertainty], truth.disc)
    for (const question of ['frequency', 'stiffness', 'rate', 'reynolds'] as const) {
      const typed = hand[question].map((value) => value.toPrecision(6)) as [string, string]
      expect([question, ...typed, check(...typed, key[question]).verdict]).toEqual([question, ...typed, 'right'])
    }
  })
})
