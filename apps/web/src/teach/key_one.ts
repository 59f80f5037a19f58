// The answers of lab one, found by the core for a student's own oscillator.
import type { Options } from '../core/types'
import type { Oscillator } from './own_oscillator'
import { slipsOf, units, type AskCore, type Expected, type QuestionOne } from './questions'

/// [%] off a lab's value, where a class has no tolerance of its own: more than what textbooks leave out.
export const usualTolerance = 2

/// Null where the core could not be asked.
export async function keyOfOne({ mass, stiffness, damping, force, step }: Oscillator, ask: AskCore): Promise<Record<QuestionOne, Expected> | null> {
  const motion = async (options: Options, by = step) => {
    const law: Options = [['mass', String(mass)], ['stiffness', String(stiffness)], ['step', String(by)], ['until', String(50 * by)]]
    const answer = await ask('motion', [...law, ...options])
    return answer && answer.status !== 2 ? answer.document : null
  }
  const damped: Options = [['damping', String(damping)], ['position', '1']]
  const undamped: Options = [['damping', '0'], ['position', '1']]
  const free = await motion([...damped, ['method', 'implicit-euler']])
  const peak = free?.linear_part.resonance_frequency
  const driven = await motion([['damping', String(damping)], ['method', 'exact'], ['drive-amplitude', String(force)], ['drive-frequency', String(peak)]])
  const growing = await motion([...undamped, ['method', 'forward-euler']])
  // Limits are looked for where they are passed.
  const long = 4 / Math.sqrt(stiffness / mass)
  const forward = await motion([...damped, ['method', 'forward-euler']], long)
  const cromer = await motion([...undamped, ['method', 'euler-cromer']], long)
  if (!free || !driven || !growing || !forward || !cromer || !peak) return null
  const values: Record<QuestionOne, number | null | undefined> = {
    resonance: peak,
    amplitude: driven.runs[0]?.effective?.steady_state?.amplitude,
    forwardLimit: forward.runs[0]?.stability_limit,
    cromerLimit: cromer.runs[0]?.stability_limit,
    growth: growing.runs[0]?.energy_factor_per_cycle,
    simulatedRate: free.runs[0]?.effective?.decay_rate
  }
  const found = (question: QuestionOne) => values[question] ?? NaN
  if (!Object.values(values).every((value) => Number.isFinite(value ?? NaN))) return null
  const [ratio, rate] = [stiffness / mass, damping / (2 * mass)]
  const [amplitude, limit, growth, simulated] = [found('amplitude'), found('cromerLimit'), found('growth'), found('simulatedRate')]
  const slips: Record<QuestionOne, [name: string, value: number][]> = {
    resonance: [['hertz', peak / (2 * Math.PI)], ['periodFor', (2 * Math.PI) / peak], ['squared', ratio]],
    amplitude: [['static', force / stiffness], ['noOmega', force / damping], ['hertzFor', force / (damping * peak) * 2 * Math.PI], ['doubled', 2 * amplitude], ['halved', amplitude / 2]],
    forwardLimit: [['cromersOwn', limit], ['twice', 2 * found('forwardLimit')], ['milliseconds', 1000 * found('forwardLimit')]],
    cromerLimit: [['half', limit / 2], ['periodFor', Math.PI * limit], ['forwardsOwn', found('forwardLimit')], ['milliseconds', 1000 * limit]],
    growth: [['ofAmplitude', Math.sqrt(growth)], ['added', growth - 1], ['percent', 100 * growth], ['percent', 100 * (growth - 1)], ['oneStep', 1 + ratio * step * step]],
    simulatedRate: [['asked', rate], ['addedOnly', simulated - rate], ['ofEnergy', 2 * simulated]]
  }
  const expected = (question: QuestionOne): Expected => {
    const value = found(question)
    return { value, unit: units[question], enough: (usualTolerance / 100) * value, uncertainty: null, slips: slipsOf(slips[question]) }
  }
  return {
    resonance: expected('resonance'), amplitude: expected('amplitude'), forwardLimit: expected('forwardLimit'),
    cromerLimit: expected('cromerLimit'), growth: expected('growth'), simulatedRate: expected('simulatedRate')
  }
}
