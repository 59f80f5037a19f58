// All texts come from here: `const w = $derived(words())`, then `{w.shell.undo}`.
import { typeset } from '../look/numbers'
import { looks } from '../state/looks.svelte'
import { de } from './de'
import { en } from './en'
import type { Said } from './said'

export type Words = typeof en
export const words = (): Words => (looks.language === 'de' ? de : en)

/// What the core or the server says, in the page's language.
export const told = (said: Said): string => typeset(typeof said === 'string' ? said : said[looks.language === 'de' ? 'de' : 'en'])
