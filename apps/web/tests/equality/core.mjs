// The page's core under node: options in, document out, with its blocks of numbers in their places.
import { readFileSync } from 'node:fs'

export function openCore(path) {
  const module = new WebAssembly.Module(readFileSync(path))
  const imports = {}
  for (const each of WebAssembly.Module.imports(module)) (imports[each.module] ??= {})[each.name] = () => 0
  const core = new WebAssembly.Instance(module, imports).exports
  core._initialize()

  const put = (content) => {
    const at = core.page_allocate(content.length || 1)
    new Uint8Array(core.memory.buffer, at, content.length).set(content)
    return at
  }

  /// `options`: pairs of name and value.
  return (task, options, file) => {
    const request = Buffer.from([task, ...options.map(([name, value]) => `${name}=${value}`)].join('\n'))
    const at = put(request)
    const fileAt = file ? put(file) : 0
    const status = core.page_answer(at, request.length, fileAt, file?.length ?? 0)
    core.page_release(at)
    if (fileAt) core.page_release(fileAt)
    const text = Buffer.from(new Uint8Array(core.memory.buffer, core.page_text(), core.page_text_length()))
    const numbers = new Float64Array(
      core.memory.buffer,
      core.page_numbers(),
      core.page_numbers_length(),
    ).slice()
    // Sentences come in both languages; the program speaks English.
    const isSentence = (value) => typeof value?.en === 'string' && typeof value.de === 'string'
    const document = JSON.parse(text.toString(), (_, value) =>
      Array.isArray(value?.block)
        ? Array.from(numbers.subarray(value.block[0], value.block[0] + value.block[1]))
        : isSentence(value)
          ? value.en
          : value,
    )
    return { status, document }
  }
}
