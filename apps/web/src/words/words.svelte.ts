// All texts come from here: `const w = $derived(words())`, then `{w.shell.undo}`.
import { looks } from '../state/looks.svelte'
import { de } from './de'
import { en } from './en'

export type Words = typeof en
export const words = (): Words => (looks.language === 'de' ? de : en)
