// What a plot without curves says.
import { page } from '../state/page.svelte'
import { words } from '../words/words.svelte'

/** Why it stays empty; nothing where the core has only not answered yet. */
export const whyEmpty = (): string => (page.simulate.methods.length === 0 ? words().simulate.empty : '')
