import { describe, expect, it } from 'vitest'
import type { Fit } from '../../src/core/types'
import { csvOf, fileNameOf, handInOf, mark, readHandIn, whoIs, type HandIn } from '../../src/teach/hand_in'
import type { AskCore } from '../../src/teach/key'

const answers = Object.fromEntries(
  ['frequency', 'stiffness', 'rate', 'reynolds', 'off'].map((question, i) => [question, { value: String(i + 1), uncertainty: '0.1' }]),
) as HandIn['answers']
const fit = {
  law: 'viscous+drag',
  parameters: { stiffness: { value: 17.04, standard_error: 0.02, unit: 'N/m', confidence_95: [17, 17.08] } },
  derived: {},
} as unknown as Fit
const one = handInOf({ name: 'Ada, "Lovelace"', course: '7F3A', student: '19' }, answers, fit, 'https://school.example/lab.html#teach')

describe('a hand-in', () => {
  it('is read back as it was written', () => {
    expect(readHandIn(JSON.stringify(one))).toEqual(one)
    expect(one.fit).toEqual({ law: 'viscous+drag', parameters: { stiffness: { value: 17.04, standard_error: 0.02, unit: 'N/m' } } })
    expect(handInOf({ name: '', course: 'A', student: '1' }, answers, null, '').fit).toBeNull()
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
    expect(await mark(one, silent)).toEqual({ handIn: one, checked: null, right: 0 })
  })
  it('is a row of a table, whatever the name', () => {
    const lines = csvOf([{ handIn: one, checked: null, right: 0 }]).split('\n')
    expect(lines[0]).toMatch(/^\ufeffname,class,student,right,frequency,frequency ±,frequency verdict,/)
    expect(lines[1]).toMatch(/^"Ada, ""Lovelace""",7F3A,19,0,1,0\.1,,/)
    const evil = { ...one, name: '=HYPERLINK("x")', answers: { ...one.answers, off: { value: '-3.8', uncertainty: '+x' } } }
    const row = csvOf([{ handIn: evil, checked: null, right: 0 }]).trim().split('\n')[1]!
    expect(row).toMatch(/^"'=HYPERLINK/)
    expect(row).toContain(",-3.8,'+x,")
  })
})
