// The whole state of the page: plain data, in one place. What is in `document` goes into the address and can be undone;
// how the page looks (theme, language) is kept by the browser.
import { measureDefaults, type MeasureState } from '../measure/state'
import { simulateDefaults, type SimulateState } from '../simulate/state'
import { teachDefaults, type TeachState } from '../teach/state'

export type TabName = 'simulate' | 'measure' | 'teach'
export interface PageDocument {
  tab: TabName
  simulate: SimulateState
  measure: MeasureState
  teach: TeachState
}

export const defaults = (): PageDocument => ({
  tab: 'simulate',
  simulate: { ...simulateDefaults, methods: [...simulateDefaults.methods] },
  measure: structuredClone(measureDefaults),
  teach: structuredClone(teachDefaults),
})

/** Read it anywhere; write it only inside `change` (undo.svelte.ts), so that it can be undone. */
export const page: PageDocument = $state(defaults())

/** Puts `next` in place of everything. */
export function replace(next: PageDocument): void {
  Object.assign(page, next)
}
