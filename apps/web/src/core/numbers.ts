// How numbers stand in the core's documents.

export type Numbers = Float64Array
/** null: not finite, or not known. */
export type Maybe = number | null
