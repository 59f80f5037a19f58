// The state as the address has it: `#simulate?mass=2&method=rk4`. Only what differs from the defaults is written.
import { measureRules } from '../measure/state'
import { simulateRules } from '../simulate/state'
import { teachRules } from '../teach/state'
import { defaults, type PageDocument, type TabName } from './page.svelte'
import type { Rules } from './rules'

type Plain = number | string | boolean | string[] | null
type Part = Record<string, Plain>
const tabs: TabName[] = ['simulate', 'measure', 'teach']
const rules = { simulate: simulateRules, measure: measureRules, teach: teachRules }

const base = defaults()

const textOf = (value: Plain): string => (Array.isArray(value) ? value.join(',') : String(value))

/** `text` as the kind of value that `like` is; undefined where it is none. */
function read(text: string, like: Plain): Plain | undefined {
  if (Array.isArray(like)) return text === '' ? [] : text.split(',')
  if (typeof like === 'boolean') return text === 'true' ? true : text === 'false' ? false : undefined
  if (typeof like !== 'number') return text
  const value = Number(text)
  return text !== '' && Number.isFinite(value) ? value : undefined
}

/** The part of the address behind #. Values of other pages are written too, as `measure.file=…`. */
export function addressOf(document: PageDocument): string {
  const values = new URLSearchParams()
  for (const tab of tabs) {
    const now = document[tab] as Part
    const before = base[tab] as Part
    for (const key of Object.keys(before))
      if (textOf(now[key]) !== textOf(before[key]))
        values.set(tab === document.tab ? key : `${tab}.${key}`, textOf(now[key]))
  }
  const text = values.toString().replaceAll('%2C', ',')
  return `#${document.tab}${text ? `?${text}` : ''}`
}

/** A value of an address that is not possible, and what stands in its place. */
export interface Replaced {
  key: string // as in the address
  text: string
  by: string
}

/** Of an address, whatever it is: what cannot be read, or breaks a rule, keeps its default. */
export function readAddress(address: string): { document: PageDocument; replaced: Replaced[] } {
  const document = defaults()
  const [name, query] = address.replace(/^#/, '').split('?', 2)
  const tab = tabs.find((each) => each === name)
  if (!tab) return { document, replaced: [] }
  document.tab = tab
  const given: { key: string; text: string; part: Part; field: string; read: boolean }[] = []
  for (const [key, text] of new URLSearchParams(query ?? '')) {
    const [head, tail] = key.split('.', 2)
    const of = tail ? tabs.find((each) => each === head) : tab
    const field = tail ?? key
    const part = of && (document[of] as Part)
    if (!part || !Object.hasOwn(part, field)) continue
    const value = read(text, part[field])
    if (value !== undefined) part[field] = value
    given.push({ key, text, part, field, read: value !== undefined })
  }
  const broken = tabs.flatMap((each) => keepToRules(document[each] as Part, defaults()[each] as Part, rules[each] as Rules<Part>))
  const replaced = given
    .filter(({ part, field, read }) => !read || broken.some((each) => each.part === part && each.field === field))
    .map(({ key, text, part, field }) => ({ key, text, by: textOf(part[field]!) }))
  return { document, replaced }
}

export const documentOf = (address: string): PageDocument => readAddress(address).document

/** The fields that were against the rules. */
function keepToRules(part: Part, otherwise: Part, rules: Rules<Part>): { part: Part; field: string }[] {
  const broken = Object.keys(rules).filter((field) => {
    if (rules[field]!(part[field]!, part)) return false
    part[field] = otherwise[field]!
    return true
  })
  return broken.map((field) => ({ part, field }))
}
