import { binds, whole } from '../python.ts'
import { numberFunction } from '../parts/number-functions.ts'

const ways: ReadonlyMap<string, readonly [name: string, more: string]> = new Map([
  ['ROUND', ['floor', ' + 0.5']],
  ['ROUNDUP', ['ceil', '']],
  ['ROUNDDOWN', ['floor', '']],
])

/** Half is rounded up. */
export const math_round = numberFunction(
  'math_round',
  'expert',
  [
    ['ROUND', 'round', Math.round],
    ['ROUNDUP', 'roundUp', Math.ceil],
    ['ROUNDDOWN', 'roundDown', Math.floor],
  ],
  (py) => {
    const [name, more] = ways.get(py.field('OP', 'ROUND')) ?? py.gap('problem.unknownChoice')
    return whole(`${py.from('math', name)}(${py.value('NUM', more ? binds.sum : binds.any)}${more})`)
  },
)
