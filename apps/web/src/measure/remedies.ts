// What can be done at once about something that the core says: a change of the settings, by its button.
import type { measure } from '../words/en/measure'
import { heartOf, type NoticeObject } from '../words/said'
import type { MeasureState } from './state'

export interface Remedy {
  name: string
  change: Partial<MeasureState>
}

type Words = typeof measure
type Spoken = Pick<NoticeObject, 'code' | 'values'>

/// Of a motion that does not die down as a free one does.
const maybeDriven = ['amplitude_rises', 'swing_does_not_die_down', 'amplitude_hardly_falls', 'swing_keeps_itself']

/// `part`: what is used of the recording [s], and the time between its samples; `drive`: whether one is looked for already.
/// Null where nothing can be done by a button.
export function remedyOf(notice: Spoken, part: { from: number; to: number; spacing: number; drive: string }, words: Words): Remedy | null {
  const { code, values } = heartOf(notice)
  const at = (name: string): number => (typeof values[name] === 'number' ? values[name] : NaN)
  const trim = (change: Partial<MeasureState>) => ({ name: words.remedies.trim, change })
  const text = (time: number) => String(Number(time.toPrecision(7)))
  if (code === 'bad_row') return { name: words.remedies.skip, change: { skip: true } }
  if (maybeDriven.includes(code)) return part.drive ? null : { name: words.remedies.driven, change: { drive: 'auto' } }
  if (code === 'swing_stops' && at('from') > part.from) return trim({ to: text(at('from')) })
  if (code === 'turns_over_at_first' && at('time') < part.to) return trim({ from: text(at('time')) })
  // the longer side of a jump, which is at the first sample after it
  const [before, after] = code === 'zero_jumps' ? [at('time') - part.spacing / 2, at('time')] : code === 'time_jumps' ? [at('from'), at('to')] : [NaN, NaN]
  if (before > part.from && after < part.to) return trim(before - part.from > part.to - after ? { to: text(before) } : { from: text(after) })
  return null
}
