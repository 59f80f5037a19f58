// The program beside it.
import { spawnSync } from 'node:child_process'

/// A sentence of the program as the page says it: "--drive-frequency" is "drive frequency" there.
export const onPage = (text) => text.replace(/--([a-z][a-z-]*)/g, (_, option) => option.replaceAll('-', ' '))

/// Exit status, and standard error's first message without the program's name before it.
export function run(cromer, command, parameters, options) {
  const named = options.map(([name, value]) => `--${name}=${value}`)
  const done = spawnSync(cromer, [command, ...parameters, ...named], { encoding: 'utf8', maxBuffer: 1 << 28 })
  if (done.error) throw done.error
  return { status: done.status, output: done.stdout, message: done.stderr.trim().replace(/^cromer: /, '') }
}
