// What the core and the server say: a sentence in both languages, or a text of the page's own.
export type Said = string | { en: string; de: string }

/// A notice with all that it knows; `values` by name.
export interface NoticeObject {
  code: string
  severity: 'wrong_if_ignored' | 'worth_knowing' | 'detail'
  text: Said
  values: Values
}

export const english = (said: Said): string => (typeof said === 'string' ? said : said.en)

/// What the core does not take: why, and the option at fault (null: none is).
export interface Refusal {
  message: Said
  argument: string | null
  code: string
  values: Values
}
type Values = Record<string, unknown>

/// What is said in the end, of a file, a line or a run: { code: 'bad_row', values }.
export function heartOf(notice: { code: string; values: Values }): { code: string; values: Values } {
  const what = notice.values.what as { code?: string; values?: Values } | undefined
  return notice.code.startsWith('in_') && what?.code && what.values ? heartOf({ code: what.code, values: what.values }) : notice
}

/// Without the name of the option that it begins with: its field stands beside it. Or with `name` in its place.
export const besideField = ({ message, argument }: Refusal, name = ''): Said => {
  const begins = english(message).startsWith(`${argument?.replaceAll('-', ' ')}: `)
  const named = (text: string) => (begins ? text.replace(/^.*?: /, () => (name ? `${name}: ` : '')) : text)
  return typeof message === 'string' ? named(message) : { en: named(message.en), de: named(message.de) }
}

/// Of a file: its name before it, where the sentence does not begin with it.
export const ofFile = (name: string, said: Said): Said => {
  const named = (text: string) => (name === '' || text.startsWith(name) ? text : `${name}: ${text}`)
  return typeof said === 'string' ? named(said) : { en: named(said.en), de: named(said.de) }
}

/// With a capital letter first.
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1)

/// A sentence of the core's that stands by itself.
export const asSentence = (text: string): string => `${capital(text)}${/[.!?:]$/.test(text) ? '' : '.'}`
