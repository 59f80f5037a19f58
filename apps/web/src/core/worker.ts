// A worker that a core runs in, so that the page never waits for it. The first message brings the module, or its
// bytes; each one after it is a question.
import { refusal, start, type Core, type Written } from './core'
import { unlzma } from './lzma'
import { moduleOf } from './streams'
import { bytesOf } from './text'
import type { Options, Task } from './types'
import { unpack } from './unpack'

/// `packed`: the module as pack.ts packs it, for the worker to compile it and to hand it back.
export type Start = { module: WebAssembly.Module } | { packed: string }

/// null: it cannot be handed on here.
export type Started = { module: WebAssembly.Module | null }

export interface Question {
  id: number
  task: Task
  options: Options
  file?: Uint8Array
  fileName?: string
}

export interface Reply extends Written {
  id: number
  took: number // [ms] of the core
}

const compile = async (packed: string) => WebAssembly.compile(moduleOf(unlzma(bytesOf(packed))))

let begin: (core: Promise<Core>) => void
const core = new Promise<Core>((resolve) => (begin = resolve))

function handOn(module: WebAssembly.Module | null): void {
  try {
    self.postMessage({ module } satisfies Started)
  } catch {
    if (module) handOn(null)
  }
}

self.onmessage = async ({ data }: MessageEvent<Start | Question>) => {
  if ('packed' in data) {
    const module = compile(data.packed)
    begin(module.then(start))
    module.then(handOn, () => handOn(null))
    return
  }
  if ('module' in data) return begin(start(data.module))
  const { id, task, file, fileName } = data
  const options: Options = fileName === undefined ? data.options : [...data.options, ['file-name', fileName]]
  let written: Written
  let began = performance.now()
  try {
    const recording = file && (await unpack(file))
    const { answer } = await core
    began = performance.now()
    written = answer(task, options, recording)
  } catch (error) {
    written = refusal(error instanceof Error ? error.message : String(error))
  }
  const reply: Reply = { id, took: performance.now() - began, ...written }
  self.postMessage(reply, { transfer: [reply.numbers.buffer] })
}
