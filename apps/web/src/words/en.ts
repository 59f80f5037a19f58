import { glossary } from './en/glossary'
import { measure } from './en/measure'
import { methods } from './en/methods'
import { shell } from './en/shell'
import { simulate } from './en/simulate'
import { teach } from './en/teach'

export const en = { glossary, shell, methods, simulate, measure, teach }
