import { minus } from '../parts/python.ts'
import { binds, whole, type Expression, type PythonAt } from '../python.ts'
import { exp, ln, log10, pow } from '@botgarten/numbers'
import { numberFunction } from '../parts/number-functions.ts'

const by = (name: string) => (py: PythonAt) => whole(`${py.from('math', name)}(${py.value('NUM')})`)

/** Pybricks has one logarithm alone. */
const works: ReadonlyMap<string, (py: PythonAt) => Expression> = new Map([
  ['ROOT', by('sqrt')],
  ['ABS', (py) => whole(`abs(${py.value('NUM')})`)],
  ['NEG', (py) => ({ code: minus(py.expression('NUM')), binds: binds.sign })],
  ['LN', by('log')],
  [
    'LOG10',
    (py) => ({ code: `${by('log')(py).code} / ${py.from('math', 'log')}(10)`, binds: binds.product }),
  ],
  ['EXP', by('exp')],
  ['POW10', (py) => whole(`pow(10, ${py.value('NUM')})`)],
  ['SQUARE', (py) => whole(`pow(${py.value('NUM')}, 2)`)],
])

export const math_single = numberFunction(
  'math_single',
  'expert',
  [
    ['ROOT', 'root', Math.sqrt],
    ['ABS', 'absolute', Math.abs],
    ['NEG', 'negative', (x) => 0 - x],
    ['LN', 'ln', ln],
    ['LOG10', 'log10', log10],
    ['EXP', 'exp', exp],
    ['POW10', 'pow10', (x) => pow(10, x)],
    ['SQUARE', 'square', (x) => x * x],
  ],
  (py) => (works.get(py.field('OP', 'ROOT')) ?? py.gap('problem.unknownChoice'))(py),
)
