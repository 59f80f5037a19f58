// The page's side of the core: questions to the worker, answers as promises.
import type { Answer, Options, Task } from './types'
import type { Question, Reply } from './worker'

export interface Asking {
  file?: Uint8Array
  fileName?: string
  /// Of the questions waiting in one channel only the newest is put: a slider moves faster than answers come.
  channel?: string
}

/// The answer, or null where a newer question of the same channel took this one's place.
export type Ask = <T extends Task>(task: T, options: Options, asking?: Asking) => Promise<Answer<T> | null>

interface Waiting {
  question: Question
  channel: string | undefined
  settle(answer: Answer | null): void
}

/// Asks the core in `worker` (worker.ts), to which it sends the module first, gzipped or not. One question is
/// with the worker at a time; the others wait here, where they can still be overtaken.
export function connect(worker: Worker, module: Uint8Array): Ask {
  const waiting: Waiting[] = []
  let asked: Waiting | undefined
  let count = 0

  function next() {
    asked = waiting.shift()
    if (asked) worker.postMessage(asked.question)
  }

  worker.onmessage = ({ data }: MessageEvent<Reply>) => {
    if (data.id !== asked?.question.id) return
    const { id: _, ...answer } = data
    asked.settle(answer as Answer)
    next()
  }
  // Only a worker that could not be read ends up here: what goes wrong in a task is an answer.
  worker.onerror = (event) => {
    asked?.settle({ status: 2, document: { message: event.message || 'the worker could not be started' } })
    next()
  }
  worker.postMessage({ module })

  return <T extends Task>(task: T, options: Options, { file, fileName, channel }: Asking = {}) =>
    new Promise<Answer<T> | null>((resolve) => {
      const settle = (answer: Answer | null) => resolve(answer as Answer<T> | null)
      const question: Question = { id: ++count, task, options, file, fileName }
      const overtaken = channel === undefined ? -1 : waiting.findIndex((each) => each.channel === channel)
      const entry = { question, channel, settle }
      if (overtaken >= 0) waiting.splice(overtaken, 1, entry)[0]!.settle(null)
      else waiting.push(entry)
      if (!asked) next()
    })
}
