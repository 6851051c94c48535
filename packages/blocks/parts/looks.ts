import type { Colour } from '@botgarten/simulation'
import type { BlockType } from '../packs/packs.ts'
import type { FieldLook, InputLook, ValueType, When } from '../types.ts'

type Options = Extract<FieldLook, { kind: 'choice' }>['options']

export const value = (name: string, ...accepts: readonly ValueType[]): InputLook => ({
  name,
  kind: 'value',
  accepts,
})
export const statements = (name: string): InputLook => ({ name, kind: 'statements' })
export const hidden = (name: string, preset = ''): FieldLook => ({ name, kind: 'hidden', preset })

/** The first option is the preset where none is named. */
export const choice = (name: string, options: Options, preset = options[0]?.value ?? ''): FieldLook => ({
  name,
  kind: 'choice',
  preset,
  options,
})

/** An option with words of its own: key in the section `choice`. */
export const worded = (value: string, words: string, dot?: Colour) => ({
  value,
  words: `choice.${words}`,
  ...(dot === undefined ? {} : { dot }),
})
export const plain = (value: string) => ({ value, words: null })

export const sensorPort = (preset: string) => choice('SENSORPORT', ['1', '2', '3', '4'].map(plain), preset)
/** Which motor's encoder; Open Roberta calls that a sensor's port, too. */
export const encoderPort = (preset: string) => choice('SENSORPORT', ['A', 'B', 'C', 'D'].map(plain), preset)
export const timerNumber = choice('SENSORPORT', ['1', '2', '3', '4', '5'].map(plain))
export const motorPort = (preset: string) => choice('MOTORPORT', ['A', 'B', 'C', 'D'].map(plain), preset)

/** Message keys of the rows of a block, counted from 0. */
export const rows = (type: BlockType, count: number): readonly string[] =>
  Array.from({ length: count }, (_, k) => `block.${type}.row${k}`)

export const words = (type: BlockType) => ({ help: `block.${type}.help`, name: `block.${type}.name` })

/** A value input that is there only while a field or an attribute says so. */
export const valueWhen = (name: string, when: When, ...accepts: readonly ValueType[]): InputLook => ({
  name,
  kind: 'value',
  accepts,
  when,
})
