import { describe, expect, it } from 'vitest'
import { optionNames } from '../../src/measure/questions'
import { measure as de } from '../../src/words/de/measure'
import { besideField, type Refusal } from '../../src/words/said'

const refusal = (argument: string | null, en: string, german: string): Refusal => ({ message: { en, de: german }, argument, code: 'option_is_wrong', values: {} })

describe('a refusal', () => {
  it('stands beside its field without the name of the option, in both languages', () => {
    expect(besideField(refusal('disc-diameter', 'disc diameter: it must be positive', 'Scheibendurchmesser: das muss größer als 0 sein'))).toEqual({
      en: 'it must be positive', de: 'das muss größer als 0 sein',
    })
  })
  it('has the page’s own name of the setting elsewhere', () => {
    const why = refusal('drive-frequency', 'drive frequency: “$1” is no number', 'drive frequency: „$1“ ist keine Zahl')
    expect(besideField(why, optionNames(de)['drive-frequency'])).toMatchObject({ de: 'Frequenz des Antriebs: „$1“ ist keine Zahl' })
  })
  it('keeps a sentence that begins otherwise', () => {
    const message = { en: 'no rows of numbers: none', de: 'keine Zeilen mit Zahlen: keine' }
    expect(besideField({ ...refusal(null, '', ''), message }, 'x')).toEqual(message)
    expect(besideField({ ...refusal('from', '', ''), message }, 'x')).toEqual(message)
  })
})
