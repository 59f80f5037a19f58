// What a person typed into a field, read by the core: "20 ms" is 0.02 s. No other parser is in the page.
import { asTyped } from '../look/numbers'
import { besideField, type Said } from '../words/said'
import { ask } from './ask'

export type Read = { value: number } | { message: Said }

/** `option`: the option of `cromer simulate` that takes it. SI out. Of a bad value the core's own message. */
export async function readQuantity(option: string, text: string): Promise<Read> {
  const answer = await ask('quantity', [[option, asTyped(text)]])
  if (!answer) return { message: '' }
  if (answer.status === 2) return { message: besideField(answer.document) }
  return { value: answer.document[option]! }
}
