// What a person typed into a field, read by the core: "20 ms" is 0.02 s. No other parser is in the page.
import { asTyped } from '../look/numbers'
import { ask } from './ask'
import type { Parameters } from './types'

export type Read = { value: number } | { message: string }

/** `option`: the option of `cromer simulate` that takes it; "until" too. SI out. Of a bad value the core's own message. */
export async function readQuantity(option: string, text: string): Promise<Read> {
  const as = option === 'until' ? 'step' : option // both are times; until would run that long
  const typed = asTyped(text).replaceAll('\n', ' ')
  const options: [string, string][] = [['method', 'dormand-prince']]
  if (as === 'step') options.push(['step', typed], ['until', '1e-9'])
  else options.push([as, typed], ['step', '1e-3'], ['until', '1e-3'])
  if (as.startsWith('drive')) options.push([as === 'drive-frequency' ? 'drive-amplitude' : 'drive-frequency', '1'])
  const answer = await ask('simulate', options)
  if (!answer) return { message: '' }
  if (answer.status === 2) return { message: answer.document.message.replace(/^--[a-z-]+: /, '') }
  const run = answer.document.runs[0]!
  if (as === 'step') return { value: run.step }
  const value = run.parameters[as.replaceAll('-', '_') as keyof Parameters]
  return typeof value === 'number' ? { value } : { message: text }
}
