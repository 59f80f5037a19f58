import { glossary } from './de/glossary'
import { measure } from './de/measure'
import { methods } from './de/methods'
import { shell } from './de/shell'
import { simulate } from './de/simulate'
import { teach } from './de/teach'
import type { en } from './en'

export const de: typeof en = { glossary, shell, methods, simulate, measure, teach }
