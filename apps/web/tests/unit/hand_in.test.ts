import { describe, expect, it } from 'vitest'
import type { Fit } from '../../src/core/types'
import { commonOptions, csvOf, fileNameOf, handInOf, mark, readHandIn, whoIs, type HandIn } from '../../src/teach/hand_in'
import { optionsDefaults, optionsOf, packed, stateOf, unpacked, type OptionsState } from '../../src/teach/options'
import { countOf, predictionsOf, stepToPredict } from '../../src/teach/predictions'
import type { AskCore } from '../../src/teach/questions'

const answers = Object.fromEntries(
  ['frequency', 'stiffness', 'rate', 'reynolds', 'off'].map((question, i) => [question, { value: String(i + 1), uncertainty: '0.1' }]),
) as HandIn['answers']
const fit = {
  law: 'viscous+drag',
  parameters: { stiffness: { value: 17.04, standard_error: 0.02, unit: 'N/m', confidence_95: [17, 17.08] } },
  derived: {},
} as unknown as Fit
const who = { name: 'Ada, "Lovelace"', course: '7F3A', student: '19', options: optionsDefaults, answers, predictions: [] }
const one = handInOf(who, fit, 'https://school.example/lab.html#teach')
const row = (handIn: HandIn) => ({ handIn, options: optionsOf(handIn.options), checked: null, right: 0, of: 5, otherOptions: false })

describe('a hand-in', () => {
  it('is read back as it was written', () => {
    expect(readHandIn(JSON.stringify(one))).toEqual(one)
    expect(one.fit).toEqual({ law: 'viscous+drag', parameters: { stiffness: { value: 17.04, standard_error: 0.02, unit: 'N/m' } } })
    expect(handInOf(who, null, '').fit).toBeNull()
  })
  it('has a name that every disk takes', () => {
    expect(fileNameOf(one)).toBe('hand-in-7F3A-19.json')
    expect(fileNameOf({ course: 'a/b', student: 'Zoë 3' })).toBe('hand-in-A_B-Zoë_3.json')
  })
  it.each(['', '{', '[]', 'null', '3', '{"cromer": "fit"}', '{"cromer": "hand-in", "version": 2}', '{"cromer": "hand-in", "version": 1, "name": 3}'])(
    'is not %s',
    (text) => expect(readHandIn(text)).toBeNull(),
  )
  it('holds a link with all settings of all pages', () => {
    const long = { ...one, link: `https://school.example/lab.html#teach?${'values=1%3B2&'.repeat(200)}` }
    expect(readHandIn(JSON.stringify(long))).toEqual(long)
  })
  it('is of one student however they type', () => {
    expect(whoIs({ ...one, student: ' 19', course: '7f3a' })).toBe(whoIs(one))
    expect(whoIs({ ...one, name: 'Grace' })).not.toBe(whoIs(one))
  })
  it('may lack answers', () => {
    const few = readHandIn(JSON.stringify({ ...one, answers: { frequency: { value: '1.4', uncertainty: 3 } } }))!
    expect(few.answers.frequency).toEqual({ value: '1.4', uncertainty: '' })
    expect(few.answers.off).toEqual({ value: '', uncertainty: '' })
  })
  it('is not marked where the core does not answer', async () => {
    const silent: AskCore = async () => null
    expect(await mark(one, silent)).toEqual({ ...row(one), of: 0 })
  })
  it('is a row of a table, whatever the name', () => {
    const lines = csvOf([row(one)]).split('\n')
    expect(lines[0]).toMatch(/^\ufeffname,class,student,right,of,frequency,frequency ±,frequency verdict,/)
    expect(lines[1]).toMatch(/^"Ada, ""Lovelace""",7F3A,19,0,5,1,0\.1,,/)
    const evil = { ...one, name: '=HYPERLINK("x")', answers: { ...one.answers, off: { value: '-3.8', uncertainty: '+x' } } }
    const line = csvOf([row(evil)]).trim().split('\n')[1]!
    expect(line).toMatch(/^"'=HYPERLINK/)
    expect(line).toContain(",-3.8,'+x,")
  })
  it('is marked by what its class has, and said where it was answered under something else', async () => {
    const task = { text: 'How long is a metre; in feet?', answer: '3,28', unit: 'ft', tolerance: '1' }
    const options: OptionsState = { labs: ['one'], hide: false, tolerance: 0, tasks: packed([task, { ...task, answer: '', unit: '' }]) }
    const handIn = { ...one, options, answers: { 'task 1': { value: '3.3 ft', uncertainty: '' }, 'task 2': { value: 'about as long as a guitar', uncertainty: '' } } }
    const silent: AskCore = async () => null
    expect(await mark(handIn, silent)).toMatchObject({ checked: null, otherOptions: false })
    const onlyTasks = { ...options, labs: [] as string[], hide: true }
    expect(await mark(handIn, silent, onlyTasks)).toMatchObject({ otherOptions: true })
    expect(commonOptions([one, handIn, { ...handIn, student: '20' }])).toEqual(options)
  })
  it('tells predictions that were left out', () => {
    const predictions = predictionsOf('one', ['1:1', '2:x', '3:0'])
    expect(predictions).toEqual([{ lab: 'one', step: 1, guess: 1 }, { lab: 'one', step: 2, guess: null }, { lab: 'one', step: 3, guess: 0 }])
    expect(countOf(predictions)).toEqual({ asked: 3, right: 1, without: 1 })
    expect(readHandIn(JSON.stringify({ ...one, predictions }))!.predictions).toEqual(predictions)
    expect(readHandIn(JSON.stringify({ ...one, predictions: [{ lab: 'three' }, null, { lab: 'one', step: 7, guess: 1 }, { lab: 'two', step: 3, guess: 9 }] }))!.predictions).toEqual([])
  })
})

describe('a prediction', () => {
  it('is asked for before a later step gives it away', () => {
    expect(stepToPredict('one', [], 1)).toBe(1)
    expect(stepToPredict('one', ['1:1', '3:x'], 7)).toBe(2)
    expect(stepToPredict('one', ['1:1', '2:1', '3:1', '4:1', '5:1', '6:x'], 7)).toBeNull()
    expect(stepToPredict('two', [], 2)).toBeNull()
  })
})

describe('options of a class', () => {
  it('are read back from its link as they were set', () => {
    const tasks = [{ text: 'Größe „Ä“, 5 = ? & #', answer: '-1.5', unit: 'µm', tolerance: '' }]
    expect(unpacked(packed(tasks))).toEqual(tasks)
    expect(packed(tasks)).toMatch(/^[\w-]+$/)
    expect(packed(tasks)).not.toContain('1.5')
    expect(packed([])).toBe('')
    expect(stateOf(optionsOf({ labs: ['one', 'two'], hide: true, tolerance: 5, tasks: packed(tasks) }))).toEqual({ labs: ['one', 'two'], hide: true, tolerance: 5, tasks: packed(tasks) })
    expect(optionsOf(optionsDefaults).labs).toEqual(['two'])
  })
  it.each(['x', 'e30', 'W1tdXQ', packed([{ text: 'a', answer: 'b'.repeat(41), unit: '', tolerance: '' }])])('are none in %s', (text) =>
    expect(unpacked(text)).toBeNull(),
  )
})
