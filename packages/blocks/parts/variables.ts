import type { Block, FieldLook, Memory, Next, Template, Value, ValueType } from '../types.ts'
import { plugged } from './rows.ts'
import { done, fail } from './next.ts'
import { field } from './fields.ts'

type Named = 'variable' | 'function' | 'neuron'
const names = { variable: 'VAR', function: 'NAME', neuron: 'NAME' } as const

/** A field that uses a name of the program; `makeName`: one that makes it. */
export const nameField = (of: Named, preset: string, name: string = names[of]): FieldLook => ({
  name,
  kind: 'name',
  of,
  preset,
})
export const makeName = (of: 'variable' | 'function', preset: string): FieldLook => ({
  name: names[of],
  kind: 'name',
  of,
  makes: true,
  preset,
})

/** The variable that the block in VAR names; '' where there is none. */
export function targetOf(block: Block, input = 'VAR'): string {
  const target = plugged(block, input)
  return target?.type === 'variables_get' ? field(target, 'VAR') : ''
}

export const assign = (memory: Memory, name: string, value: Value): Next =>
  memory.set(name, value) ? done : fail('noSuchVariable', { name })

/** A start block that makes one variable, for examples. */
export const declared = (name: string, type: ValueType, value: Template): Template => ({
  type: 'robControls_start',
  mutation: { attrs: { declare: 'true' } },
  fields: { DEBUG: 'FALSE' },
  statements: {
    ST: [
      {
        type: 'robGlobalVariables_declare',
        mutation: { attrs: { next: 'false', declaration_type: type } },
        fields: { VAR: name, TYPE: type },
        values: { VALUE: value },
      },
    ],
  },
})

export const variable = (name: string, type: ValueType = 'Number'): Template => ({
  type: 'variables_get',
  mutation: { attrs: { datatype: type } },
  fields: { VAR: name },
})
