// The core leaves out the sentences of tasks that it has not (core/CMakeLists.txt): nothing that it has may say one.
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'

const root = fileURLToPath(new URL('../../../..', import.meta.url))
const filesIn = (folder: string) =>
  readdirSync(`${root}${folder}`, { recursive: true, encoding: 'utf8' })
    .map((name) => `${folder}/${name}`)
    .filter((path) => /\.(cpp|h)$/.test(path))
const textOf = (path: string) => readFileSync(`${root}${path}`, 'utf8')

it('has every sentence that it can say', () => {
  const build = textOf('apps/web/core/CMakeLists.txt')
  const leftOut = [...build.matchAll(/EXCLUDE REGEX "([^"]+)"/g)].map(([, regex]) => new RegExp(regex!))
  const isLeftOut = (path: string) => leftOut.some((regex) => regex.test(path))
  const words = filesIn('src/cromer/documents/words')
  const missing = words
    .filter(isLeftOut)
    .flatMap((path) => [...textOf(path).matchAll(/^ +\{"(\w+)", (?:error|clause|wrong_if_ignored|worth_knowing|detail),/gm)])
    .map(([, code]) => code!)
  expect(missing.length).toBeGreaterThan(300)

  const folders = [...new Set([...build.matchAll(/\$\{cromer\}\/([\w/]+)\/\*\.cpp/g)].map(([, folder]) => `src/cromer/${folder}`))]
  expect(folders).toContain('src/cromer/tasks')
  const files = [...build.matchAll(/\$\{cromer\}\/([\w/]+\.cpp)/g)].map(([, file]) => `src/cromer/${file}`)
  expect(files).toContain('src/cromer/documents/json.cpp')
  const compiled = [...folders.flatMap(filesIn), ...files, ...filesIn('src/cromer/documents/json'), ...filesIn('apps/web/core')]
    .filter((path) => !isLeftOut(path))
    .map(textOf)
    .join('\n')
  expect(missing.filter((code) => compiled.includes(`"${code}"`))).toEqual([])
})
