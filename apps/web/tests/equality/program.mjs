// The program beside it.
import { spawnSync } from 'node:child_process'

/// A sentence of the program as the page says it: "--drive-frequency" is "drive frequency" there.
export const onPage = (text) => text.replace(/--([a-z][a-z-]*)/g, (_, option) => option.replaceAll('-', ' '))

/// Whether both say the same. Where the program names an option for a cure, the page has a button or its handles: then the
/// cure, behind the last semicolon, is its own.
export function sameWords(page, program) {
  if (!/--(skip-bad-rows|column|rate|time-column|from|to)\b/.test(program)) return page === onPage(program)
  const fault = (text) => text.slice(0, Math.max(text.lastIndexOf('; '), 0) || text.length)
  return fault(page) === fault(program)
}

/// Exit status, and standard error's first message without the program's name before it.
export function run(cromer, command, parameters, options) {
  const named = options.map(([name, value]) => `--${name}=${value}`)
  const done = spawnSync(cromer, [command, ...parameters, ...named], { encoding: 'utf8', maxBuffer: 1 << 28 })
  if (done.error) throw done.error
  return { status: done.status, output: done.stdout, message: done.stderr.trim().replace(/^cromer: /, '') }
}
