// A core in the page itself, for what it computes in less time than a frame can spare: the curves then move in the
// very frame in which the slider does. Everything else goes to a worker, so that the page never stutters.
import { compiled } from './ask'
import type { Answered } from './client'
import { read, start, type Core } from './core'
import type { Options, Task } from './types'

const spare = 4 // [ms] of a frame of 16

let core: Core | null = null
void compiled.then(async (module) => {
  core = module && (await start(module))
})

/// [ms] that a step of each kind of question took the last time, here or in the worker.
const pace = new Map<string, number>()

/// `kind`: questions that cost alike, step by step.
export function learn(kind: string, steps: number, took: number): void {
  pace.set(kind, took / steps)
}

/// null: what is known of this kind says that it would take too long, or nothing is known yet.
export function answerAtOnce<T extends Task>(task: T, options: Options, kind: string, steps: number): Answered<T> | null {
  if (!core || !((pace.get(kind) ?? Infinity) * steps <= spare)) return null
  const began = performance.now()
  try {
    const answer = read<T>(core.answer(task, options))
    const took = performance.now() - began
    learn(kind, steps, took)
    return { ...answer, took }
  } catch {
    core = null // it could not be started again here
    return null
  }
}
