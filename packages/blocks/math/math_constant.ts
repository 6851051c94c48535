import { binds, whole, type PythonAt, type Expression } from '../python.ts'
import { show, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'math_constant'

const constants: ReadonlyMap<string, number> = new Map([
  ['PI', Math.PI],
  ['E', Math.E],
  ['GOLDEN_RATIO', (1 + Math.sqrt(5)) / 2],
  ['SQRT2', Math.SQRT2],
  ['SQRT1_2', Math.SQRT1_2],
  ['INFINITY', Infinity],
])

const root = (py: PythonAt, of: string) => whole(`${py.from('math', 'sqrt')}(${of})`)

type Write = (py: PythonAt) => Expression

const pythonConstants: ReadonlyMap<string, Write> = new Map<string, Write>([
  ['PI', (py) => whole(py.from('math', 'pi'))],
  ['E', (py) => whole(`${py.from('math', 'exp')}(1)`)],
  ['GOLDEN_RATIO', (py) => ({ code: `(1 + ${root(py, '5').code}) / 2`, binds: binds.product })],
  ['SQRT2', (py) => root(py, '2')],
  ['SQRT1_2', (py) => root(py, '0.5')],
  ['INFINITY', () => whole('float("inf")')],
])

/** INFINITY is the one value without end. */
export const math_constant: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'math',
    shape: 'value',
    output: 'Number',
    fields: [
      choice('CONSTANT', [
        worded('PI', 'pi'),
        worded('E', 'e'),
        worded('GOLDEN_RATIO', 'goldenRatio'),
        worded('SQRT2', 'sqrt2'),
        worded('SQRT1_2', 'sqrtHalf'),
        worded('INFINITY', 'infinity'),
      ]),
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run(block) {
    const x = constants.get(field(block, 'CONSTANT', 'PI'))
    return x === undefined ? fail('unknownChoice') : give(x)
  },
  python: (py) => pythonConstants.get(py.field('CONSTANT', 'PI'))?.(py) ?? py.gap('problem.unknownChoice'),
  example: [start, show({ type, fields: { CONSTANT: 'PI' } })],
}
