import type { Template } from '../types.ts'

type Make = (args: readonly Template[]) => Template

export interface ExpressionFunction {
  /** How many values it takes; null: any number. */
  readonly takes: number | null
  readonly make: Make
}

const values = (names: readonly string[], args: readonly Template[]): Template['values'] =>
  Object.fromEntries(names.flatMap((name, k) => (args[k] ? [[name, args[k]]] : [])))

const takes = (
  names: readonly string[],
  make: (values: Template['values']) => Template,
): ExpressionFunction => ({
  takes: names.length,
  make: (args) => make(values(names, args)),
})

const single = (type: string, OP: string) => takes(['NUM'], (values) => ({ type, fields: { OP }, values }))

const property = (PROPERTY: string): ExpressionFunction =>
  takes(PROPERTY === 'DIVISIBLE_BY' ? ['NUMBER_TO_CHECK', 'DIVISOR'] : ['NUMBER_TO_CHECK'], (values) => ({
    type: 'math_number_property',
    fields: { PROPERTY },
    values,
  }))

const onList = (OP: string) =>
  takes(['LIST'], (values) => ({
    type: 'math_on_list',
    mutation: { attrs: { op: OP } },
    fields: { OP },
    values,
  }))

const find = (END: string) =>
  takes(['VALUE', 'FIND'], (values) => ({ type: 'robLists_indexOf', fields: { END }, values }))

const entry = (MODE: string, WHERE: string) =>
  takes(WHERE.startsWith('FROM') ? ['VALUE', 'AT'] : ['VALUE'], (values) => ({
    type: 'robLists_getIndex',
    fields: { MODE, WHERE },
    values,
  }))

const sublist = (WHERE1: string, WHERE2: string) =>
  takes(
    ['LIST', ...(WHERE1.startsWith('FROM') ? ['AT1'] : []), ...(WHERE2.startsWith('FROM') ? ['AT2'] : [])],
    (values) => ({ type: 'robLists_getSublist', fields: { WHERE1, WHERE2 }, values }),
  )

const rows = (type: string): ExpressionFunction => ({
  takes: null,
  make: (args) => ({
    type,
    mutation: { attrs: { items: String(args.length) } },
    values: Object.fromEntries(args.map((arg, k) => [`ADD${k}`, arg])),
  }),
})

const plain = (type: string, ...names: readonly string[]) => takes(names, (values) => ({ type, values }))

/** Functions of expressions, by Open Roberta's names (its grammar TextlyJava), as the blocks that mean the same. */
export const functions: ReadonlyMap<string, ExpressionFunction> = new Map([
  ...(['sin', 'cos', 'tan', 'asin', 'acos', 'atan'] as const).map(
    (name) => [name, single('math_trig', name.toUpperCase())] as const,
  ),
  ['exp', single('math_single', 'EXP')],
  ['square', single('math_single', 'SQUARE')],
  ['sqrt', single('math_single', 'ROOT')],
  ['abs', single('math_single', 'ABS')],
  ['log', single('math_single', 'LN')],
  ['log10', single('math_single', 'LOG10')],
  ['pow10', single('math_single', 'POW10')],
  ['floor', single('math_round', 'ROUNDDOWN')],
  ['ceil', single('math_round', 'ROUNDUP')],
  ['round', single('math_round', 'ROUND')],
  ['randomInt', plain('math_random_int', 'FROM', 'TO')],
  ['randomFloat', plain('math_random_float')],
  ['randomItem', onList('RANDOM')],
  ['isEven', property('EVEN')],
  ['isOdd', property('ODD')],
  ['isPrime', property('PRIME')],
  ['isWhole', property('WHOLE')],
  ['isPositive', property('POSITIVE')],
  ['isNegative', property('NEGATIVE')],
  ['isDivisibleBy', property('DIVISIBLE_BY')],
  ['isEmpty', plain('robLists_isEmpty', 'VALUE')],
  ['sum', onList('SUM')],
  ['max', onList('MAX')],
  ['min', onList('MIN')],
  ['average', onList('AVERAGE')],
  ['median', onList('MEDIAN')],
  ['stddev', onList('STD_DEV')],
  ['size', plain('robLists_length', 'VALUE')],
  ['indexOfFirst', find('FIRST')],
  ['indexOfLast', find('LAST')],
  ['get', entry('GET', 'FROM_START')],
  ['getFromEnd', entry('GET', 'FROM_END')],
  ['getFirst', entry('GET', 'FIRST')],
  ['getLast', entry('GET', 'LAST')],
  ['getAndRemove', entry('GET_REMOVE', 'FROM_START')],
  ['getAndRemoveFromEnd', entry('GET_REMOVE', 'FROM_END')],
  ['getAndRemoveFirst', entry('GET_REMOVE', 'FIRST')],
  ['getAndRemoveLast', entry('GET_REMOVE', 'LAST')],
  ['createListWith', rows('robLists_create_with')],
  ['createEmptyList', rows('robLists_create_with')],
  ['subList', sublist('FROM_START', 'FROM_START')],
  ['subListFromIndexToLast', sublist('FROM_START', 'LAST')],
  ['subListFromIndexToEnd', sublist('FROM_START', 'FROM_END')],
  ['subListFromFirstToIndex', sublist('FIRST', 'FROM_START')],
  ['subListFromFirstToLast', sublist('FIRST', 'LAST')],
  ['subListFromFirstToEnd', sublist('FIRST', 'FROM_END')],
  ['subListFromEndToIndex', sublist('FROM_END', 'FROM_START')],
  ['subListFromEndToEnd', sublist('FROM_END', 'FROM_END')],
  ['subListFromEndToLast', sublist('FROM_END', 'LAST')],
  ['createTextWith', rows('robText_join')],
  ['constrain', plain('math_constrain', 'VALUE', 'LOW', 'HIGH')],
  ['castToString', plain('math_cast_toString', 'VALUE')],
  ['castToChar', plain('math_cast_toChar', 'VALUE')],
  ['castStringToNumber', plain('text_cast_string_toNumber', 'VALUE')],
  ['castToNumber', plain('text_cast_char_toNumber', 'VALUE', 'AT')],
])
