import type { BlockType } from '../packs/packs.ts'
import type { Definition, Faces, FieldLook, Template, ValueType } from '../types.ts'
import { hidden, rows, words } from './looks.ts'

/** What all blocks share that read a sensor: Open Roberta's files have MODE, a port and SLOT in each. */
export const sample = (
  type: BlockType,
  mode: FieldLook,
  port: FieldLook,
  output: ValueType = 'Number',
  faces?: Faces,
): Pick<Definition, 'type' | 'look' | 'words' | 'acts'> => ({
  type,
  look: {
    category: 'sensors',
    shape: 'value',
    output,
    fields: [mode, port, hidden('SLOT')],
    inputs: [],
    mutation: { mode: { field: 'MODE' } },
    ...(faces && { faces }),
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
})

/** Such a block in an example. */
export const reading = (type: BlockType, mode: string, port: string): Template => ({
  type,
  fields: { MODE: mode, SENSORPORT: port, SLOT: '' },
})
