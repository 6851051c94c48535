import { whole, type Expression, type PythonAt, type ValueType } from '@botgarten/blocks'

const helpers: { readonly [kind: string]: string } = {
  Number: 'number_text',
  Boolean: 'truth_text',
  Colour: 'color_name',
}

/** A value as the display shows it (semantics.md, rule 12). */
export function textIn(at: PythonAt, input: string): Expression {
  const value = at.expression(input)
  const kind = at.kind(input)
  if (kind === 'String') return value
  if (value.code === 'None') return whole('""')
  if (kind === 'Number' && /^-?\d{1,15}(\.\d{1,4})?$/.test(value.code)) return whole(`"${value.code}"`)
  return whole(textOf(at, value.code, kind))
}

function textOf(at: PythonAt, code: string, kind: ValueType | 'any'): string {
  const known = helpers[kind]
  if (known) return at.call(known, code)
  if (!kind.startsWith('Array_')) return at.call('str', code)
  const each = helpers[kind.slice('Array_'.length)]
  return at.call('list_text', code, each ? at.call(each).replace(/\(\)$/, '') : 'str')
}
