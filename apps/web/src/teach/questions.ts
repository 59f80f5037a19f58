// What the labs ask for, and what a right answer is.
import type { Answer, Options, Task } from '../core/types'

export type Lab = 'one' | 'two'

export const questionsOf = {
  one: ['resonance', 'amplitude', 'forwardLimit', 'cromerLimit', 'growth', 'simulatedRate'],
  two: ['frequency', 'stiffness', 'rate', 'reynolds', 'off']
} as const satisfies Record<Lab, readonly string[]>
export type QuestionOne = (typeof questionsOf.one)[number]
export type QuestionTwo = (typeof questionsOf.two)[number]
export type Question = QuestionOne | QuestionTwo

/// What each is asked for in.
export const units: Record<Question, string> = {
  resonance: 'rad/s', amplitude: 'm', forwardLimit: 's', cromerLimit: 's', growth: '', simulatedRate: '1/s',
  frequency: 'Hz', stiffness: 'N/m', rate: '1/s', reynolds: '', off: '%'
}

export type Slips = { name: string; value: number }[]

/// What is right, in the unit asked for, and what a common slip gives in its place.
export interface Expected {
  value: number
  unit: string
  /// Its sign is not asked for.
  unsigned?: boolean
  /// So near is right, and no ± is needed; 0 where the ± decides.
  enough: number
  /// Null: none is asked for.
  uncertainty: Uncertainty | null
  slips: Slips
}

export interface Uncertainty {
  /// What a careful evaluation cannot do without, which is the page's own; and the largest that still says something.
  least: number
  most: number
  /// So far off is a right value whatever its ±: twice the least one, and at least as far as the page's own value and the lab's own formula.
  within: number
}

export type Key = Partial<Record<string, Expected>>

export type AskCore = <T extends Task>(
  task: T,
  options: Options,
  asking?: { file?: Uint8Array; fileName?: string }
) => Promise<Answer<T> | null>

export const slipsOf = (slips: [name: string, value: number][]): Slips => slips.map(([name, value]) => ({ name, value }))
