// What the Measure page keeps in the address. Recordings themselves never leave the page.
import { countTo, type Rules } from '../state/rules'

export const measureDefaults = {
  /// Empty: the core's choice.
  column: '',
  run: 1,
  /// Samples per second of a file without times.
  rate: '',
  /// The free part [s]; empty: from the first sample, to the last.
  from: '',
  to: '',
  /// As in --law; empty: the core compares all of them.
  law: '',
  /// 'auto': looked for a drive in the recording; empty: only where a free motion does not describe it.
  drive: '',
  /// Rows that are no numbers are left out.
  skip: false,
  mass: '',
  disc: '',
  air: '20 °C',
  /// Simulations of the fitted law beside the recording.
  overlay: false
}
export type MeasureState = typeof measureDefaults

/// Texts go to the core as they are, which says what is wrong with them.
export const measureRules: Rules<MeasureState> = { run: countTo(10_000) }
