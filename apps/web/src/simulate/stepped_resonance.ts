// The resonance curve of a law that is not linear: stepped by Dormand-Prince at a few frequencies, each from rest.
import { askAside } from '../core/ask'
import type { ResonanceCurve, Motion } from '../core/types'
import { decayRate, period } from './law'
import { resonanceOptions } from './options'
import type { SimulateState } from './state'

const points = 41
const least = 30 // periods before the swing is read off
const most = 200
const read = 3 // of the drive's periods, at the end

/** Largest |x| of the last three periods of the drive; it has settled if the three before them say the same. */
function swing(run: Motion): { amplitude: number; settled: boolean } {
  const { t, x } = run.states
  const span = (read * 2 * Math.PI) / run.drive_frequency
  let [last, before] = [0, 0]
  for (let i = 0; i < t.length; ++i) {
    if (t[i]! >= run.until - span) last = Math.max(last, Math.abs(x[i]!))
    else if (t[i]! >= run.until - 2 * span) before = Math.max(before, Math.abs(x[i]!))
  }
  return { amplitude: last, settled: Math.abs(last - before) <= 0.02 * last }
}

/** Points where the motion has not settled are left out. Null where a newer question took its place. */
export async function steppedResonance(s: SimulateState, from: number, to: number): Promise<ResonanceCurve[] | null> {
  const law = resonanceOptions(s, from, to).filter(([name]) => !['frequencies', 'drive-frequency', 'method', 'step'].includes(name))
  const decay = decayRate(s) > 0 ? 8 / decayRate(s) : 0
  const until = Math.min(most * period(s), Math.max(least * period(s), decay)) + (2 * read * 2 * Math.PI) / from
  const frequencies = Array.from({ length: points }, (_, i) => from + ((to - from) * i) / (points - 1))
  const answer = await askAside(
    'motion',
    [
      ...law, ...frequencies.map((each): [string, string] => ['drive-frequency', String(each)]), ['position', '0'],
      ['method', 'dormand-prince'], ['tolerance', '1e-6'], ['step', String(Math.min(period(s), (2 * Math.PI) / to) / 24)], ['until', String(until)],
    ],
    { channel: 'resonance' },
  )
  if (!answer) return null
  if (answer.status === 2) return []
  const found = answer.document.runs.map((run) => ({ frequency: run.drive_frequency, ...swing(run) })).filter((each) => each.settled)
  return [
    {
      method: 'dormand-prince', settled: found.length > 1, phase: new Float64Array(),
      frequency: Float64Array.from(found, (each) => each.frequency), amplitude: Float64Array.from(found, (each) => each.amplitude),
    },
  ]
}
