import type { FieldLook, Frame, Next, Template, Value } from '../types.ts'
import { number } from './examples.ts'
import { choice, worded } from './looks.ts'
import { fail, give } from './next.ts'

/** No list of a running program is longer, no text has more letters. */
export const mostEntries = 10_000

/** The k-th value of a frame as a list, itself and not a copy: who changes it changes every variable that holds it. */
export function listAt(frame: Frame, k: number): Value[] {
  const value = frame.got[k]
  return Array.isArray(value) ? (value as Value[]) : []
}

/** A block that goes through a list uses up one block of the tick's budget more for each hundred entries. */
export const costOf = (entries: number): number => Math.floor(entries / 100)

export const wheres = (name: string, preset: 'FROM_START' | 'FIRST' | 'LAST' = 'FROM_START'): FieldLook =>
  choice(
    name,
    [
      worded('FROM_START', 'placeNumber'),
      worded('FROM_END', 'placeFromEnd'),
      worded('FIRST', 'firstEntry'),
      worded('LAST', 'lastEntry'),
    ],
    preset,
  )

/** Which place WHERE and AT mean, counted from 0; fractions are cut off. null where that is before the first. */
export function placeIn(list: readonly Value[], where: string, at: number): number | null {
  const place = placeOf(list.length, where, Math.trunc(at))
  return place >= 0 ? place : null
}

function placeOf(length: number, where: string, at: number): number {
  if (where === 'FIRST') return 0
  if (where === 'LAST') return Math.max(0, length - 1)
  return where === 'FROM_END' ? length - 1 - at : at
}

/** A text that may have grown too long. */
export const grown = (text: string): Next =>
  text.length > mostEntries ? fail('textTooLong', { most: mostEntries }) : give(text)

/** Three numbers, for examples. */
export const someList: Template = {
  type: 'robLists_create_with',
  mutation: { attrs: { items: '3', list_type: 'Number' } },
  fields: { LIST_TYPE: 'Number' },
  values: { ADD0: number(1), ADD1: number(2), ADD2: number(3) },
}
