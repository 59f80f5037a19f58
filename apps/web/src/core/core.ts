// The core in its WebAssembly module: bytes in, documents out. In the page it runs in a worker, in the tests
// under node.
import { withBlocks } from './blocks'
import type { Answer, Options, Task } from './types'

interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  page_allocate(bytes: number): number
  page_release(pointer: number): void
  page_answer(request: number, length: number, file: number, fileLength: number): number
  page_text(): number
  page_text_length(): number
  page_numbers(): number
  page_numbers_length(): number
}

/// An answer as the core writes it, and as it travels: a document, and the blocks of numbers that it refers to.
export interface Written {
  status: 0 | 1 | 2
  text: string
  numbers: Float64Array<ArrayBuffer>
}

export interface Core {
  /// Runs one task to its end. `file`: a recording, of tasks that read one; its name is the option "file-name".
  answer(task: Task, options: Options, file?: Uint8Array): Written
}

/// What stands in an answer.
export const read = <T extends Task>({ status, text, numbers }: Written): Answer<T> =>
  ({ status, document: withBlocks(JSON.parse(text), numbers) }) as Answer<T>

/// What goes wrong outside of a task, as an answer.
export const refusal = (message: string): Written => ({
  status: 2,
  text: JSON.stringify({ message, argument: null, code: '', values: {} }),
  numbers: new Float64Array(),
})

export async function start(module: WebAssembly.Module): Promise<Core> {
  // The module asks a system for little (arguments, an output for its last words), and gets none of it.
  const imports: Record<string, Record<string, () => number>> = {}
  for (const each of WebAssembly.Module.imports(module)) (imports[each.module] ??= {})[each.name] = () => 0
  let exports = begin(await WebAssembly.instantiate(module, imports))
  return {
    answer(task, options, file) {
      try {
        return ask(exports, task, options, file)
      } catch (error) {
        // Its memory may be in any state after that; the next question gets a new one.
        exports = begin(new WebAssembly.Instance(module, imports))
        return refusal(message(error))
      }
    },
  }
}

function begin(instance: WebAssembly.Instance): Exports {
  const exports = instance.exports as unknown as Exports
  exports._initialize()
  return exports
}

function message(error: unknown): string {
  if (error instanceof RangeError || /memory|unreachable/.test(String(error)))
    return 'the computation needs more memory than the page has: ask for fewer states or samples'
  return `the computation broke off: ${error}`
}

function ask(core: Exports, task: Task, options: Options, file?: Uint8Array): Written {
  const lines = options.map(([name, value]) => `${name}=${value.replace(/[\r\n]+/g, ' ')}`)
  const request = new TextEncoder().encode([task, ...lines].join('\n'))
  const at = put(core, request)
  const fileAt = file ? put(core, file) : 0
  const status = core.page_answer(at, request.length, fileAt, file?.length ?? 0) as Written['status']
  core.page_release(at)
  if (fileAt) core.page_release(fileAt)
  const { buffer } = core.memory
  const text = new TextDecoder().decode(new Uint8Array(buffer, core.page_text(), core.page_text_length()))
  // The memory is used again by the next question.
  const numbers = new Float64Array(buffer, core.page_numbers(), core.page_numbers_length()).slice()
  return { status, text, numbers }
}

function put(core: Exports, bytes: Uint8Array): number {
  const at = core.page_allocate(bytes.length || 1)
  if (at === 0) throw new RangeError('no memory')
  new Uint8Array(core.memory.buffer, at, bytes.length).set(bytes)
  return at
}
