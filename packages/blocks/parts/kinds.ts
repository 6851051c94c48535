import type { InputLook, ListType, PlainType, Typed, ValueType } from '../types.ts'
import { choice, worded } from './looks.ts'

const plainKinds: readonly PlainType[] = ['Number', 'String', 'Boolean', 'Colour', 'Connection']
export const listKinds: readonly ListType[] = plainKinds.map((kind) => `Array_${kind}` as const)
/** What a variable may hold. */
export const kinds: readonly ValueType[] = [...plainKinds, ...listKinds]
export const isKind = (text: string): text is PlainType | ListType =>
  (kinds as readonly string[]).includes(text)

/** The list type of a type; a list's own where it is one already. */
export const listOf = (kind: ValueType): ValueType =>
  (plainKinds as readonly string[]).includes(kind) ? `Array_${kind as PlainType}` : kind
/** The type of a list's entries. */
export const entryOf = (kind: ValueType): ValueType =>
  kind.startsWith('Array_') ? (kind.slice(6) as PlainType) : kind

const words: { readonly [kind in PlainType | ListType]: string } = {
  Number: 'number',
  String: 'text',
  Boolean: 'truth',
  Colour: 'colourKind',
  Connection: 'connection',
  Array_Number: 'numbers',
  Array_String: 'texts',
  Array_Boolean: 'truths',
  Array_Colour: 'colours',
  Array_Connection: 'connections',
}

/** A field that names a type: `TYPE`, `LIST_TYPE`. */
export const kindField = (name: string, of: readonly (PlainType | ListType)[] = kinds as never) =>
  choice(
    name,
    of.map((kind) => worded(kind, words[kind])),
  )
export const plainKindField = (name: string) => kindField(name, plainKinds)

export const typedBy = (by: Typed['by'], rest: Omit<Typed, 'by' | 'preset'>): Typed => ({
  by,
  preset: 'Number',
  ...rest,
})

/** An input for a list of any type. */
export const listInput = (name: string): InputLook => ({ name, kind: 'value', accepts: listKinds })
/** An input for any value a variable may hold. */
export const anyInput = (name: string): InputLook => ({ name, kind: 'value', accepts: kinds })
