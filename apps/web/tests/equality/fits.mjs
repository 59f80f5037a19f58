// One fit in both.
//
// An estimator stops where the next step would be below 1e-5 of every parameter's standard error. Sines and
// exponentials that differ by their last digit lead both to within that of the same minimum, so each value is
// due to 1e-4 of its standard error, and the standard error itself to 1e-4 of its own. Where parameters can
// hardly be told apart, a step that is small beside each error still moves the residual's rms: it is due to 1e-8.
// The law chosen, the status and every text are the same.
import { writeFileSync } from 'node:fs'
import { join } from 'node:path'

import { onPage, run, sameWords } from './program.mjs'
import { differences } from './runs.mjs'

const share = 1e-4

function estimates(kind, ours, theirs) {
  const names = new Set([...Object.keys(ours), ...Object.keys(theirs)])
  return [...names].flatMap((name) => {
    const page = ours[name],
      program = theirs[name]
    if (!page || !program) return [`${kind}.${name} is in one of them only`]
    const error = program.standard_error
    const near = (a, b) => a === b || Math.abs(a - b) <= Math.max(share * error, 1e-12 * Math.abs(b))
    return near(page.value, program.value) && near(page.standard_error, error)
      ? []
      : [
          `${kind}.${name}: ${page.value} ± ${page.standard_error}, the program has ${program.value} ± ${error}`,
        ]
  })
}

export function compareFit(core, cromer, folder, { name, bytes, options }) {
  const file = join(folder, `${name}.fit.csv`)
  writeFileSync(file, bytes)
  const theirs = run(cromer, 'fit', [file, '--json', '--quiet'], options)
  const ours = core('fit', [...options, ['file-name', file]], bytes)
  if (ours.status !== theirs.status)
    return [
      `status ${ours.status} (${ours.document.message}), the program's ${theirs.status}: ${theirs.message}`,
    ]
  if (theirs.status === 2)
    return sameWords(ours.document.message, theirs.message)
      ? []
      : [`"${ours.document.message}", the program says "${theirs.message}"`]
  const program = JSON.parse(theirs.output),
    page = ours.document.fits[0]
  const found = ['recording', 'law', 'status'].flatMap((each) =>
    differences(each, page[each], program[each], 0),
  )
  const codes = (fit) => fit.notices.map(({ code, severity }) => `${code}, ${severity}`)
  found.push(...differences('notices', codes(page), codes(program), 0))
  // The page has handles where some sentences of the program have options.
  const words = ({ message, warnings }) => [message ?? '', ...warnings]
  const [said, saidThere] = [words(page), words(program)]
  for (const [i, text] of saidThere.entries())
    if (!/--(from|to|column)\b/.test(text)) found.push(...differences('text', said[i], onPage(text), 0))
  if (page.parameters && program.parameters) {
    found.push(...estimates('parameters', page.parameters, program.parameters))
    found.push(...estimates('derived', page.derived, program.derived))
    found.push(...differences('rms', page.residual.rms, program.residual.rms, 1e-8))
    found.push(
      ...differences(
        'candidates',
        page.candidates.map((each) => each.law),
        program.candidates.map((each) => each.law),
        0,
      ),
    )
  }
  return found
}
