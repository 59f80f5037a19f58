// The worker that the core runs in, so that the page never waits for it. The first message brings the module,
// gzipped or not; each one after it is a question.
import { buffersOf } from './blocks'
import { open, type Core } from './core'
import type { Answer, Options, Task } from './types'
import { unpack } from './unpack'

export interface Question {
  id: number
  task: Task
  options: Options
  file?: Uint8Array
  fileName?: string
}

export type Reply = { id: number } & Answer

let core: Promise<Core> | undefined

self.onmessage = async ({ data }: MessageEvent<{ module: Uint8Array } | Question>) => {
  if ('module' in data) {
    core = open(data.module)
    return
  }
  const { id, task, file, fileName } = data
  const options: Options = fileName === undefined ? data.options : [...data.options, ['file-name', fileName]]
  let answer: Answer
  try {
    if (!core) throw new Error('the core was not sent')
    answer = (await core).answer(task, options, file && (await unpack(file)))
  } catch (error) {
    answer = { status: 2, document: { message: error instanceof Error ? error.message : String(error) } }
  }
  const reply: Reply = { id, ...answer }
  self.postMessage(reply, { transfer: buffersOf(answer.document) })
}
