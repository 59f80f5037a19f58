// The messages that stand in the core's sources, as templates: {} for what is put in. A reader of C++ that knows
// only how messages are written here: fmt::format("..."), concat({...}), and literals joined by +.
import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

const literal = /"(?:[^"\\]|\\.)*"/g
const plain = (quoted: string): string =>
  quoted.slice(1, -1).replaceAll('\\u00a0', '\u00a0').replace(/\\(.)/g, (_, c: string) => (c === 'n' ? '\n' : c))

/// From the bracket at `open` to the one that closes it; what stands between them.
function inside(text: string, open: number): string {
  const pairs: Record<string, string> = { '(': ')', '{': '}', '[': ']' }
  const waiting: string[] = []
  for (let i = open; i < text.length; ++i) {
    const c = text[i]!
    if (c === '"') {
      literal.lastIndex = i
      const found = literal.exec(text)
      if (!found || found.index !== i) return ''
      i += found[0].length - 1
    } else if (c === "'" && /^'(\\.|[^'\\])'/.test(text.slice(i, i + 4))) i += text[i + 1] === '\\' ? 3 : 2
    else if (pairs[c]) waiting.push(pairs[c])
    else if (c === waiting.at(-1)) {
      waiting.pop()
      if (waiting.length === 0) return text.slice(open + 1, i)
    }
  }
  return ''
}

/// Parts between `mark`s that stand in no bracket and no literal.
function parts(text: string, mark: string): string[] {
  const found: string[] = []
  let depth = 0
  let from = 0
  for (let i = 0; i < text.length; ++i) {
    const c = text[i]!
    if (c === '"') {
      literal.lastIndex = i
      i += (literal.exec(text)?.[0].length ?? 1) - 1
    } else if ('([{'.includes(c)) ++depth
    else if (')]}'.includes(c)) --depth
    else if (c === mark && depth === 0) {
      found.push(text.slice(from, i))
      from = i + 1
    }
  }
  return [...found, text.slice(from)].map((part) => part.trim())
}

/// What an expression says: its alternatives, where it chooses between some.
function said(expression: string): string[] {
  const text = expression.trim()
  const whole = text.match(/^"(?:[^"\\]|\\.)*"$/)
  if (whole) return [plain(whole[0])]
  const call = text.match(/^(fmt::format|concat|std::string|Error|refuse|wrong|leave_out)\s*[({]/)
  if (call && inside(text, call[0].length - 1).length + call[0].length + 1 === text.length) {
    const content = inside(text, call[0].length - 1)
    if (call[1] === 'concat') return joined(parts(content.trim().slice(1, -1), ','))
    const first = parts(content, ',')[0]!
    return call[1] === 'fmt::format' ? said(first).map((each) => each.replace(/\{[^}]*\}/g, '{}')) : said(first)
  }
  const question = parts(text, '?')
  if (question.length > 1) {
    const rest = text.slice(text.indexOf('?', question[0]!.length) + 1)
    const [yes, ...no] = parts(rest, ':')
    return [...said(yes!), ...said(no.join(':'))]
  }
  const sum = parts(text, '+')
  if (sum.length > 1) return joined(sum)
  return ['{}']
}
const joined = (pieces: string[]): string[] =>
  pieces.map(said).reduce((all, next) => all.flatMap((a) => next.map((b) => a + b)).slice(0, 8), [''])

/// Templates of a source text: of every message that is returned, kept or given on.
export function messagesOf(source: string): string[] {
  const text = source
    .replace(/\/\/[^\n"]*\n/g, '\n')
    .replace(/#include[^\n]*/g, '')
    .replace(/"\s*\n\s*"/g, '')
  const found = new Set<string>()
  for (const match of text.matchAll(/(?:Error|push_back|emplace_back|refuse|wrong|Refusal|FreePart|say|complain|leave_out|must)\s*([({])/g)) {
    for (const argument of parts(inside(text, match.index + match[0].length - 1), ',')) for (const each of said(argument)) found.add(each)
  }
  for (const match of text.matchAll(/(?:return|message \+?=|text \+?=|cure =|\w+ =|\?|: )\s*(?=(?:std::string\(|fmt::format|concat|"))/g)) {
    const rest = text.slice(match.index + match[0].length)
    for (const each of said(parts(rest.slice(0, 1200), ';')[0]!.split(/\n\n/)[0]!)) found.add(each)
  }
  return [...found].filter((each) => /[a-z]{2,} [a-z]/.test(each.replaceAll('{}', '')))
}

/// The sources below `root` that the page's core is made of, but for what its questions never reach.
export function coreSources(root: string, left: RegExp): { file: string; text: string }[] {
  return ['base', 'analysis', 'identify', 'read', 'run', 'model', 'methods', 'tasks'].flatMap((folder) =>
    readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((name) => /\.(cpp|h)$/.test(name) && !left.test(`${folder}/${name}`))
      .sort()
      .map((name) => ({ file: `${folder}/${name}`, text: readFileSync(join(root, folder, name), 'utf8') })),
  )
}
