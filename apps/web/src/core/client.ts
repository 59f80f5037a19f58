// The page's side of the core: questions to the worker, answers as promises.
import { read, refusal, type Written } from './core'
import type { Answer, Options, Task } from './types'
import type { Question, Reply, Started } from './worker'

export interface Asking {
  file?: Uint8Array
  fileName?: string
  /// Of the questions waiting in one channel only the newest is put: a slider moves faster than answers come.
  channel?: string
}

/// `took`: milliseconds that the core computed.
export type Answered<T extends Task> = Answer<T> & { took: number }

/// The answer, or null where a newer question of the same channel took this one's place.
export type Ask = <T extends Task>(task: T, options: Options, asking?: Asking) => Promise<Answered<T> | null>

interface Waiting {
  question: Question
  channel: string | undefined
  settle(written: (Written & { took: number }) | null): void
}

/// Asks the core in `worker` (worker.ts), which someone gives its module. One question is with the worker at a
/// time; the others wait here, where they can still be overtaken.
export function connect(worker: Worker): Ask {
  const waiting: Waiting[] = []
  let asked: Waiting | undefined
  let count = 0
  let broken: string | null = null

  function next() {
    asked = waiting.shift()
    if (asked) worker.postMessage(asked.question)
  }

  worker.addEventListener('message', ({ data }: MessageEvent<Reply | Started>) => {
    if (!('id' in data) || data.id !== asked?.question.id) return
    asked.settle(data)
    next()
  })
  // Only a worker that could not be read ends up here, and it will answer nothing: what goes wrong in a task is
  // an answer.
  worker.addEventListener('error', (event) => {
    broken = event.message || 'the worker could not be started'
    for (const each of [asked, ...waiting.splice(0)]) each?.settle({ ...refusal(broken), took: 0 })
    asked = undefined
  })

  return <T extends Task>(task: T, options: Options, { file, fileName, channel }: Asking = {}) =>
    new Promise<Answered<T> | null>((resolve) => {
      const settle: Waiting['settle'] = (written) => resolve(written && { ...read<T>(written), took: written.took })
      if (broken !== null) return settle({ ...refusal(broken), took: 0 })
      const question: Question = { id: ++count, task, options, file, fileName }
      const overtaken = channel === undefined ? -1 : waiting.findIndex((each) => each.channel === channel)
      const entry = { question, channel, settle }
      if (overtaken >= 0) waiting.splice(overtaken, 1, entry)[0]!.settle(null)
      else waiting.push(entry)
      if (!asked) next()
    })
}
