import type { Template } from '@botgarten/blocks'
import fc from 'fast-check'

export type Any = fc.Arbitrary<Template>
type Fields = { readonly [name: string]: string }
export type Kind = 'Number' | 'String' | 'Boolean' | 'Colour'

export const one = fc.constantFrom<string[]>
const fields = (choices: { readonly [name: string]: readonly string[] }) =>
  fc.record(Object.fromEntries(Object.entries(choices).map(([name, of]) => [name, one(...of)])))

/** A block with chosen fields and given holes; a hole is very rarely a gap. */
export function made(
  type: string,
  choices: { readonly [name: string]: readonly string[] } = {},
  holes: { readonly [name: string]: Any } = {},
  attrs?: (fields: Fields) => Fields,
): Any {
  const gaps = Object.fromEntries(
    Object.entries(holes).map(([name, hole]) => [name, fc.option(hole, { freq: 150, nil: null })]),
  )
  return fc.tuple(fields(choices), fc.record(gaps)).map(([chosen, values]) => ({
    type,
    ...(attrs && { mutation: { attrs: attrs(chosen) } }),
    fields: chosen,
    values: Object.fromEntries(
      Object.entries(values).filter((entry): entry is [string, Template] => entry[1] !== null),
    ),
  }))
}

// ---- what the recording robot has

export const motors = ['A', 'B', 'C', 'D']
const numberModes: readonly (readonly [type: string, modes: readonly string[], ports: readonly string[]])[] =
  [
    ['ultrasonic', ['DISTANCE'], ['2', '3']],
    ['colour', ['LIGHT', 'AMBIENTLIGHT'], ['1']],
    ['htcolour', ['LIGHT', 'AMBIENTLIGHT'], ['1']],
    ['irseeker', ['MODULATED', 'UNMODULATED'], ['1', '4']],
    ['encoder', ['DEGREE', 'ROTATION', 'DISTANCE'], motors],
    ['timer', ['VALUE'], ['1', '2', '5']],
  ]
/** Sensors of the other robot; the first one has none at these ports. */
const rareModes: typeof numberModes = [
  ['gyro', ['ANGLE', 'RATE'], ['2']],
  ['infrared', ['DISTANCE'], ['4']],
  ['sound', ['SOUND'], ['4']],
  ['compass', ['COMPASS', 'ANGLE'], ['4']],
  ['odometry', ['X', 'Y', 'THETA'], ['4']],
]
const sensor = ([type, modes, ports]: (typeof numberModes)[number]) =>
  made(`robSensors_${type}_getSample`, { MODE: modes, SENSORPORT: ports })
const oldSensor = made('robSensors_getSample', {
  SENSORTYPE: ['ULTRASONIC_DISTANCE', 'TIMER_VALUE', 'TIME'],
  SENSORPORT: ['2', '3'],
})

// ---- values by type

const text = one('', 'Hallo', 'Bo 2', '12', '3,5 m', '-7.25e1x', 'a b').map((TEXT): Template => ({
  type: 'text',
  fields: { TEXT },
}))
const numbers = fc
  .oneof(
    { weight: 8, arbitrary: fc.integer({ min: -3, max: 40 }) },
    { weight: 2, arbitrary: fc.constantFrom(0.5, 2.5, -0.25, -1.5, 1e308, 150, 997, 65) },
  )
  .map((x): Template => ({ type: 'math_number', fields: { NUM: String(x) } }))
export const palette = [
  '#000000',
  '#0057A6',
  '#00642E',
  '#F7D117',
  '#B30006',
  '#FFFFFF',
  '#532115',
  '#585858',
]

export const variable = (name: string, datatype: string): Template => ({
  type: 'variables_get',
  mutation: { attrs: { datatype } },
  fields: { VAR: name },
})
export const names: { readonly [kind in Kind]: readonly string[] } = {
  ...{ Number: ['n', 'm', 'i'], String: ['t'], Boolean: ['b'], Colour: ['c'] },
}
export const kinds = ['Number', 'String', 'Boolean', 'Colour'] as const
const variablesOf = (kind: Kind) => one(...names[kind]).map((name) => variable(name, kind))
export const listVariable = (kind: Kind) => variable(`${kind}s`, `Array_${kind}`)

export const where = ['FROM_START', 'FROM_END', 'FIRST', 'LAST']
const counts = (place: string | undefined) => String(place?.startsWith('FROM') ?? false)

/** Text of a tree of numbers: the parser has to read the tree out of it again (rule 32). */
function printed({ type, fields = {}, values = {} }: Template): string {
  if (type === 'math_number') return `(${fields.NUM})`
  const sign = { ADD: '+', MINUS: '-', MULTIPLY: '*', DIVIDE: '/' }[fields.OP!]!
  return `(${printed(values.A!)} ${sign} ${printed(values.B!)})`
}
const plainNumber = fc
  .integer({ min: 0, max: 40 })
  .map((x): Template => ({ type: 'math_number', fields: { NUM: String(x) } }))
const { sum } = fc.letrec<{ sum: Template; tree: Template }>((tie) => ({
  sum: fc.oneof({ maxDepth: 3, withCrossShrink: true }, plainNumber, tie('tree')),
  tree: made(
    'math_arithmetic',
    { OP: ['ADD', 'MINUS', 'MULTIPLY', 'DIVIDE'] },
    { A: tie('sum'), B: tie('sum') },
  ).filter(({ values }) => Object.keys(values ?? {}).length === 2),
}))
const expression = sum.map((tree): Template => ({
  type: 'robActions_eval_expr',
  fields: { TYPE: 'Number', EXPRESSION: printed(tree) },
  // For the twin: what the text means. Ids only name blocks.
  data: JSON.stringify(tree),
}))

interface Values {
  readonly Number: Template
  readonly String: Template
  readonly Boolean: Template
  readonly Colour: Template
  readonly Connection: Template
  readonly NumberList: Template
  readonly StringList: Template
  readonly BooleanList: Template
  readonly ColourList: Template
}

export const valuesWith = (calls: boolean) =>
  fc.letrec<Values>((tie: fc.LetrecTypedTie<Values>) => {
    const get = (kind: keyof Values): Any => tie(kind)
    const number = get('Number')
    const ofList = (kind: Kind): Any[] => {
      const list = get(`${kind}List`)
      const at = (attrs: (chosen: Fields) => Fields) => (MODE: readonly string[], WHERE: readonly string[]) =>
        made(
          'robLists_getIndex',
          { MODE, WHERE },
          { VALUE: list, ...(WHERE[0]!.startsWith('FROM') && { AT: number }) },
          attrs,
        )
      const taking = at(({ WHERE }) => ({ statement: 'false', at: counts(WHERE) }))
      return [
        taking(['GET', 'GET_REMOVE'], ['FROM_START', 'FROM_END']),
        taking(['GET', 'GET_REMOVE'], ['FIRST', 'LAST']),
        made('logic_ternary', {}, { IF: get('Boolean'), THEN: get(kind), ELSE: get(kind) }),
      ]
    }
    const list = (kind: Kind): Any => {
      const item = get(kind)
      const whole = fc.constant(listVariable(kind))
      return fc.oneof(
        { maxDepth: 3, depthIdentifier: 'values', withCrossShrink: true },
        { weight: 4, arbitrary: whole },
        {
          weight: 3,
          arbitrary: fc
            .array(item, { minLength: 0, maxLength: 4, depthIdentifier: 'values' })
            .map((items): Template => ({
              type: 'robLists_create_with',
              mutation: { attrs: { items: String(items.length), list_type: kind } },
              fields: { LIST_TYPE: kind },
              values: Object.fromEntries(items.map((entry, k) => [`ADD${k}`, entry])),
            })),
        },
        {
          weight: 1,
          arbitrary: made(
            'robLists_repeat',
            { LIST_TYPE: [kind] },
            {
              ITEM: item,
              NUM: fc.oneof(numbers, fc.constant({ type: 'math_number', fields: { NUM: '260' } })),
            },
          ),
        },
        {
          weight: 1,
          arbitrary: made(
            'robLists_getSublist',
            { WHERE1: ['FROM_START', 'FROM_END'], WHERE2: where.slice(2) },
            { LIST: get(`${kind}List`), AT1: number },
            ({ WHERE2 }) => ({ at1: 'true', at2: counts(WHERE2) }),
          ),
        },
        {
          weight: 1,
          arbitrary: made(
            'robLists_getSublist',
            { WHERE1: where.slice(2), WHERE2: where.slice(0, 2) },
            { LIST: get(`${kind}List`), AT2: number },
            () => ({ at1: 'false', at2: 'true' }),
          ),
        },
      )
    }
    const deep = (simple: Any, ...rest: readonly Any[]): Any =>
      fc.oneof(
        { maxDepth: 3, depthIdentifier: 'values', withCrossShrink: true },
        simple,
        ...rest.map((arbitrary) => ({ weight: 1, arbitrary })),
      )
    const compared = fc.oneof(
      made('logic_compare', { OP: ['EQ', 'NEQ', 'LT', 'LTE', 'GT', 'GTE'] }, { A: number, B: number }),
      ...kinds.map((kind) => made('logic_compare', { OP: ['EQ', 'NEQ'] }, { A: get(kind), B: get(kind) })),
      made('logic_compare', { OP: ['EQ', 'NEQ'] }, { A: get('NumberList'), B: get('NumberList') }),
    )
    const anyList = fc.oneof(...kinds.map((kind) => get(`${kind}List`)))
    return {
      Number: deep(
        fc.oneof({ weight: 4, arbitrary: numbers }, { weight: 2, arbitrary: variablesOf('Number') }),
        made(
          'math_arithmetic',
          { OP: ['ADD', 'MINUS', 'MULTIPLY', 'DIVIDE', 'POWER'] },
          { A: number, B: number },
        ),
        made(
          'math_single',
          { OP: ['ROOT', 'ABS', 'NEG', 'LN', 'LOG10', 'EXP', 'POW10', 'SQUARE'] },
          { NUM: number },
        ),
        made('math_trig', { OP: ['SIN', 'COS', 'TAN', 'ASIN', 'ACOS', 'ATAN'] }, { NUM: number }),
        made('math_round', { OP: ['ROUND', 'ROUNDUP', 'ROUNDDOWN'] }, { NUM: number }),
        made('math_constant', { CONSTANT: ['PI', 'E', 'GOLDEN_RATIO', 'SQRT2', 'SQRT1_2', 'INFINITY'] }),
        made('math_modulo', {}, { DIVIDEND: number, DIVISOR: number }),
        made('math_constrain', {}, { VALUE: number, LOW: number, HIGH: number }),
        made('math_random_int', {}, { FROM: numbers, TO: numbers }),
        made('math_random_float'),
        made(
          'math_on_list',
          { OP: ['SUM', 'MIN', 'MAX', 'AVERAGE', 'MEDIAN', 'STD_DEV', 'RANDOM'] },
          { LIST: get('NumberList') },
          ({ OP }) => ({ op: OP! }),
        ),
        made('text_cast_string_toNumber', {}, { VALUE: get('String') }),
        made('text_cast_char_toNumber', {}, { VALUE: get('String'), AT: number }),
        made('robLists_length', {}, { VALUE: anyList }),
        ...kinds.map((kind) =>
          made(
            'robLists_indexOf',
            { END: ['FIRST', 'LAST'] },
            { VALUE: get(`${kind}List`), FIND: get(kind) },
          ),
        ),
        ...ofList('Number'),
        ...(calls ? [call('robProcedures_callreturn', 'double', [number])] : []),
        ...numberModes.map(sensor),
        oldSensor,
        fc.oneof(...rareModes.map(sensor), numbers, numbers, numbers, numbers, numbers, numbers),
        made('robActions_motor_getPower', { MOTORPORT: motors }),
        made('robActions_play_getVolume'),
        made('robSensors_get_outputneuron_val', { NAME: ['n2'] }),
        made('robSensors_get_weight', { FROM: ['n1'], TO: ['n2'] }),
        made('robSensors_get_bias', { NAME: ['n2'] }),
        expression,
      ),
      String: deep(
        fc.oneof(text, variablesOf('String')),
        fc
          .array(fc.oneof(get('String'), number, get('NumberList')), {
            minLength: 1,
            maxLength: 3,
            depthIdentifier: 'values',
          })
          .map((items): Template => ({
            type: 'robText_join',
            mutation: { attrs: { items: String(items.length) } },
            values: Object.fromEntries(items.map((entry, k) => [`ADD${k}`, entry])),
          })),
        made('math_cast_toString', {}, { VALUE: number }),
        made('math_cast_toChar', {}, { VALUE: number }),
        made('robCommunication_receiveBlock', {}, { CONNECTION: get('Connection') }),
        ...ofList('String'),
      ),
      Boolean: deep(
        fc.oneof(made('logic_boolean', { BOOL: ['TRUE', 'FALSE'] }), variablesOf('Boolean')),
        compared,
        made('logic_operation', { OP: ['AND', 'OR'] }, { A: get('Boolean'), B: get('Boolean') }),
        made('logic_negate', {}, { BOOL: get('Boolean') }),
        made(
          'math_number_property',
          { PROPERTY: ['EVEN', 'ODD', 'PRIME', 'WHOLE', 'POSITIVE', 'NEGATIVE'] },
          { NUMBER_TO_CHECK: number },
        ),
        made(
          'math_number_property',
          { PROPERTY: ['DIVISIBLE_BY'] },
          { NUMBER_TO_CHECK: number, DIVISOR: number },
        ),
        made('robLists_isEmpty', {}, { VALUE: anyList }),
        made('robSensors_key_getSample', { MODE: ['PRESSED'], SENSORPORT: ['ENTER', 'UP', 'LEFT', 'ANY'] }),
        made('robSensors_ultrasonic_getSample', { MODE: ['PRESENCE'], SENSORPORT: ['2', '3'] }),
        fc.oneof(
          {
            weight: 1,
            arbitrary: made('robSensors_touch_getSample', { MODE: ['PRESSED'], SENSORPORT: ['4'] }),
          },
          { weight: 6, arbitrary: compared },
        ),
        ...ofList('Boolean'),
      ),
      Colour: deep(
        fc.oneof(made('robColour_picker', { COLOUR: palette }), variablesOf('Colour')),
        made('robSensors_colour_getSample', { MODE: ['COLOUR'], SENSORPORT: ['1'] }),
        made('robSensors_htcolour_getSample', { MODE: ['COLOUR'], SENSORPORT: ['1'] }),
        ...ofList('Colour'),
      ),
      Connection: fc.oneof(
        { weight: 4, arbitrary: fc.constant(variable('k', 'Connection')) },
        {
          weight: 3,
          arbitrary: made(
            'robCommunication_startConnection',
            {},
            { ADDRESS: fc.constant({ type: 'text', fields: { TEXT: 'Bo 2' } }) },
          ),
        },
        { weight: 1, arbitrary: made('robCommunication_waitForConnection') },
        { weight: 1, arbitrary: made('logic_null') },
      ),
      NumberList: fc.oneof(
        { weight: 8, arbitrary: list('Number') },
        { weight: 1, arbitrary: made('robSensors_colour_getSample', { MODE: ['RGB'], SENSORPORT: ['1'] }) },
        {
          weight: 1,
          arbitrary: made('robSensors_infrared_getSample', { MODE: ['SEEK'], SENSORPORT: ['4'] }),
        },
      ),
      StringList: list('String'),
      BooleanList: list('Boolean'),
      ColourList: list('Colour'),
    }
  })

/** Functions of every program: `double` of a number, `speak` of a text. */
export function call(type: string, name: string, args: readonly Any[]): Any {
  const parameters = { double: [{ name: 'x', type: 'Number' }], speak: [{ name: 'w', type: 'String' }] }
  const holes = Object.fromEntries(args.map((arg, k) => [`ARG${k}`, arg]))
  return made(type, {}, holes).map((block) => ({
    ...block,
    mutation: { attrs: { name }, args: parameters[name as 'double'] },
  }))
}
