// What the Teach page keeps in the address: the place in the tours, the class, and the answers.
import { areMethods, countTo, notNegative, oneOf, positive, type Rules } from '../state/rules'
import { labOne } from './lab_one'
import { labTwo } from './lab_two'

export type Lab = 'one' | 'two'

export const teachDefaults = {
  lab: 'one',
  /// The step shown, from 1, of each lab; and those whose goal was reached, as "1,2".
  one: 1,
  two: 1,
  doneOne: [] as string[],
  doneTwo: [] as string[],
  /// What was expected of a step of lab one, before it was seen: "3:1" is the second answer of step 3.
  expected: [] as string[],
  course: '',
  student: '',
  /// The recording of lab two is the student's own, which is made anew when the page is opened again.
  taken: false,
  /// Answer and ± of each question in the order of key.ts, joined by ; for a comma may be a decimal one.
  values: '',
  uncertainties: '',
  // What the steps of lab one set.
  position: 0,
  damping: 0,
  driveAmplitude: 0,
  driveFrequency: 1,
  step: 0.01,
  methods: ['euler-cromer'] as string[]
}
export type TeachState = typeof teachDefaults

const steps = (count: number) => (names: string[]): boolean => names.every((name) => countTo(count)(Number(name)))
export const teachRules: Rules<TeachState> = {
  lab: oneOf('one', 'two'),
  one: countTo(labOne.length), two: countTo(labTwo.length), doneOne: steps(labOne.length), doneTwo: steps(labTwo.length),
  expected: (all) => all.every((each) => /^[1-9]:[0-2]$/.test(each)),
  damping: notNegative, driveAmplitude: notNegative, driveFrequency: positive, methods: areMethods,
  step: (step) => step >= 1e-4 // the longest step of lab one runs for 50 s
}
