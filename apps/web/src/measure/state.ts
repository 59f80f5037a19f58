// What the Measure page keeps in the address. Recordings themselves never leave the page.
export const measureDefaults = {}
export type MeasureState = typeof measureDefaults
