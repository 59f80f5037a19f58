// What the Teach page keeps in the address.
export const teachDefaults = {}
export type TeachState = typeof teachDefaults
