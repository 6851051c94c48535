import { acos, asin, atan, cos, exp, ln, log10, pow, sin, tan } from '@botgarten/numbers'
import type { Block, Value } from '@botgarten/blocks'
import type { MotorPort, ReadMode } from '@botgarten/simulation'
import { biasOf, weightOf } from './net.ts'
import { Failure, type Steps, type WholeTwin } from './twin.ts'

const fieldOf = (block: Block, name: string): string => block.fields?.[name] ?? ''

/** Rule 12. */
const colourNames: { readonly [colour: string]: string } = {
  ...{ '#000000': 'BLACK', '#0057A6': 'BLUE', '#00642E': 'GREEN', '#F7D117': 'YELLOW' },
  ...{ '#B30006': 'RED', '#FFFFFF': 'WHITE', '#532115': 'BROWN', '#585858': 'GREY' },
}
export function textOf(value: Value): string {
  if (Array.isArray(value)) return `[${(value as Value[]).map(textOf).join(', ')}]`
  if (value === Infinity || value === -Infinity) return value > 0 ? '∞' : '-∞'
  if (typeof value === 'number') return String(Number(value.toFixed(4)) + 0)
  return typeof value === 'boolean' || typeof value === 'string'
    ? (colourNames[String(value)] ?? String(value))
    : ''
}

/** Rule 11. */
function same(a: Value, b: Value): boolean {
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((entry: Value, k) => same(entry, (b as Value[])[k]!))
  return a === b
}

/** Rule 10. */
function worked(block: Block, result: number, ...from: readonly number[]): number {
  if (Number.isNaN(result)) throw new Failure(block, 'noNumber')
  const endless = from.some((x) => Math.abs(x) === Infinity)
  if (Math.abs(result) === Infinity && !endless) throw new Failure(block, 'tooBigNumber')
  return result + 0
}

const ofOne: { readonly [operation: string]: (x: number) => number } = {
  ...{ ROOT: Math.sqrt, ABS: Math.abs, NEG: (x) => -x, LN: ln, LOG10: log10, EXP: exp },
  ...{ POW10: (x) => pow(10, x), SQUARE: (x) => x * x },
  ...{ SIN: sin, COS: cos, TAN: tan, ASIN: asin, ACOS: acos, ATAN: atan },
  ...{ ROUND: (x) => Math.floor(x + 0.5), ROUNDUP: Math.ceil, ROUNDDOWN: Math.floor },
}
const ofTwo: { readonly [operation: string]: (a: number, b: number) => number } = {
  ...{ ADD: (a, b) => a + b, MINUS: (a, b) => a - b, MULTIPLY: (a, b) => a * b, DIVIDE: (a, b) => a / b },
  POWER: pow,
}
const orders: { readonly [operation: string]: (a: number, b: number) => boolean } = {
  ...{ LT: (a, b) => a < b, LTE: (a, b) => a <= b, GT: (a, b) => a > b, GTE: (a, b) => a >= b },
}
const constants: { readonly [name: string]: number } = {
  ...{ PI: Math.PI, E: Math.E, GOLDEN_RATIO: (1 + Math.sqrt(5)) / 2, INFINITY: Infinity },
  ...{ SQRT2: Math.SQRT2, SQRT1_2: Math.SQRT1_2 },
}

function isPrime(x: number): boolean {
  if (!Number.isInteger(x) || x < 2) return false
  for (let divisor = 2; divisor <= Math.sqrt(x); divisor++) if (x % divisor === 0) return false
  return true
}
const properties: { readonly [name: string]: (x: number) => boolean } = {
  EVEN: (x) => x % 2 === 0,
  ODD: (x) => Math.abs(x % 2) === 1,
  PRIME: isPrime,
  WHOLE: (x) => Math.floor(x) === x && Math.abs(x) !== Infinity,
  POSITIVE: (x) => x > 0,
  NEGATIVE: (x) => x < 0,
}

/** Rule 28. */
function statistic(operation: string, xs: readonly number[]): number {
  const sum = (values: readonly number[]) => values.reduce((total, x) => total + x, 0)
  const mean = sum(xs) / xs.length
  const sorted = xs.toSorted((a, b) => a - b)
  const half = (xs.length - 1) / 2
  switch (operation) {
    case 'SUM':
      return sum(xs)
    case 'MIN':
      return sorted[0]!
    case 'MAX':
      return sorted.at(-1)!
    case 'AVERAGE':
      return mean
    case 'MEDIAN':
      return (sorted[Math.floor(half)]! + sorted[Math.ceil(half)]!) / 2
    default:
      return Math.sqrt(sum(xs.map((x) => (x - mean) ** 2)) / xs.length)
  }
}

/** Taking an entry out of a list, or looking at it; the value is dropped where the block stands in a row. */
export function* takeEntry(twin: WholeTwin, block: Block): Steps<Value> {
  const list = yield* twin.list(block, 'VALUE')
  const where = fieldOf(block, 'WHERE')
  const at = where.startsWith('FROM') ? Math.trunc(yield* twin.number(block, 'AT')) : 0
  const last = list.length - 1
  const place = { FROM_START: at, FROM_END: last - at, FIRST: 0, LAST: Math.max(0, last) }[where as 'FIRST']
  if (place < 0 || place > last) throw new Failure(block, list.length === 0 ? 'emptyList' : 'noSuchEntry')
  return fieldOf(block, 'MODE') === 'GET' ? list[place]! : list.splice(place, 1)[0]!
}

function* sublist(twin: WholeTwin, block: Block): Steps<Value> {
  const list = yield* twin.list(block, 'LIST')
  const [from, to] = [fieldOf(block, 'WHERE1'), fieldOf(block, 'WHERE2')]
  const at1 = from.startsWith('FROM') ? Math.trunc(yield* twin.number(block, 'AT1')) : 0
  const at2 = to.startsWith('FROM') ? Math.trunc(yield* twin.number(block, 'AT2')) : 0
  const last = list.length - 1
  const placeOf = (where: string, at: number) =>
    ({ FROM_START: at, FROM_END: last - at, FIRST: 0, LAST: Math.max(0, last) })[where as 'FIRST']
  const [first, end] = [placeOf(from, at1), placeOf(to, at2)]
  if (first < 0 || end < 0) throw new Failure(block, list.length === 0 ? 'emptyList' : 'noSuchEntry')
  twin.costs(list.length)
  return list.filter((_entry, k) => k >= first && k <= end)
}

function read(twin: WholeTwin, block: Block, mode: ReadMode): number {
  const reading = twin.host.robot.read(fieldOf(block, 'SENSORPORT') as '1', mode)
  if (reading === null) throw new Failure(block, 'nothingToRead')
  return reading as number
}

/** Rule 36 and what each sensor says. `kind`: `TOUCH`, `COLOUR`, … */
function sense(twin: WholeTwin, block: Block, kind: string, mode: string): Value {
  const { robot } = twin.host
  const port = fieldOf(block, 'SENSORPORT')
  switch (kind) {
    case 'TOUCH':
      return read(twin, block, 'touch') > 0
    case 'ULTRASONIC':
      return mode === 'PRESENCE' ? read(twin, block, 'distance') < 30 : read(twin, block, 'distance')
    case 'INFRARED': {
      if (mode === 'SEEK') return [0, -128]
      // The whole way of 100 is 70 cm.
      return mode === 'PRESENCE' ? read(twin, block, 'infrared') < 100 : read(twin, block, 'infrared')
    }
    case 'COLOUR':
    case 'HTCOLOUR':
      if (mode === 'RGB')
        return (['red', 'green', 'blue'] as const).map((channel) => read(twin, block, channel))
      return mode === 'COLOUR' ? read(twin, block, 'colour') : read(twin, block, 'light')
    case 'GYRO':
      return read(twin, block, mode === 'RATE' ? 'rate' : 'angle')
    case 'SOUND':
      return read(twin, block, 'sound')
    case 'COMPASS': {
      const north = read(twin, block, 'compass')
      return mode === 'ANGLE' && north > 180 ? north - 360 : north
    }
    case 'ODOMETRY':
      return read(twin, block, ({ X: 'x', Y: 'y', THETA: 'heading' } as const)[mode as 'X'])
    case 'IRSEEKER':
      return 0
    case 'KEY':
      return robot.key(port.toLowerCase() as 'any')
    case 'ENCODER': {
      const degrees = robot.encoder(port as MotorPort)
      if (mode === 'DEGREE') return degrees
      return mode === 'ROTATION' ? degrees / 360 : (degrees / 360) * Math.PI * robot.wheelDiameter
    }
    default: {
      const ms = robot.timer(Number(port))
      if (ms === null) throw new Failure(block, 'unknownChoice')
      return ms
    }
  }
}

/** The blocks that a text expression means; what fails in them fails at it. */
const meantBy = ({ id, data }: Block): Block =>
  JSON.parse(data!, (_name, part: object) =>
    part && 'type' in Object(part) ? { ...part, id } : part,
  ) as Block

/** What a value block gives. */
export function* valueOf(twin: WholeTwin, block: Block): Steps<Value> {
  const { type } = block
  const op = fieldOf(block, 'OP')
  const sensor = /^robSensors_([a-z]+)_getSample$/.exec(type)
  if (sensor) return sense(twin, block, sensor[1]!.toUpperCase(), fieldOf(block, 'MODE'))
  switch (type) {
    case 'robSensors_getSample': {
      const [kind, mode] = fieldOf(block, 'SENSORTYPE').split('_') as [string, string?]
      return sense(twin, block, kind, mode ?? '')
    }
    case 'math_number':
      return Number(fieldOf(block, 'NUM'))
    case 'math_constant':
      return constants[fieldOf(block, 'CONSTANT')]!
    case 'math_arithmetic': {
      const [a, b] = [yield* twin.number(block, 'A'), yield* twin.number(block, 'B')]
      if (op === 'DIVIDE' && b === 0) throw new Failure(block, 'divisionByZero')
      return worked(block, ofTwo[op]!(a, b), a, b)
    }
    case 'math_single':
    case 'math_trig':
    case 'math_round': {
      const x = yield* twin.number(block, 'NUM')
      return worked(block, ofOne[op]!(x), x)
    }
    case 'math_modulo': {
      const [a, b] = [yield* twin.number(block, 'DIVIDEND'), yield* twin.number(block, 'DIVISOR')]
      if (b === 0) throw new Failure(block, 'divisionByZero')
      return worked(block, a % b, a, b)
    }
    case 'math_constrain': {
      const [x, low, high] = [
        yield* twin.number(block, 'VALUE'),
        yield* twin.number(block, 'LOW'),
        yield* twin.number(block, 'HIGH'),
      ]
      const above = x < low ? low : x
      return (above > high ? high : above) + 0
    }
    case 'math_number_property': {
      const x = yield* twin.number(block, 'NUMBER_TO_CHECK')
      if (fieldOf(block, 'PROPERTY') !== 'DIVISIBLE_BY') return properties[fieldOf(block, 'PROPERTY')]!(x)
      const divisor = yield* twin.number(block, 'DIVISOR')
      if (divisor === 0) throw new Failure(block, 'divisionByZero')
      return x % divisor === 0
    }
    case 'math_on_list': {
      const list = yield* twin.list(block, 'LIST')
      if (list.length === 0 && op !== 'SUM') throw new Failure(block, 'emptyList')
      twin.costs(list.length)
      if (op === 'RANDOM') return list[Math.floor(twin.random() * list.length)]!
      const result = statistic(op, list as readonly number[])
      if (!Number.isFinite(result)) throw new Failure(block, 'tooBigNumber')
      return result + 0
    }
    case 'math_random_int': {
      const [a, b] = [yield* twin.number(block, 'FROM'), yield* twin.number(block, 'TO')]
      const [least, most] = [Math.ceil(Math.min(a, b)), Math.floor(Math.max(a, b))]
      const drawn = least + Math.floor(twin.random() * Math.max(1, most - least + 1))
      return worked(block, drawn, a, b)
    }
    case 'math_random_float':
      return twin.random()
    case 'math_cast_toString':
      return textOf(yield* twin.ask(block, 'VALUE'))
    case 'math_cast_toChar': {
      const code = Math.trunc(yield* twin.number(block, 'VALUE'))
      if (code < 0 || code > 65535 || Number.isNaN(code)) throw new Failure(block, 'noSuchLetter')
      return String.fromCharCode(code)
    }
    case 'text_cast_string_toNumber': {
      const [text] = yield* twin.texts(block, 'VALUE')
      const begins = /^\s*[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?/i.exec(text!)
      const x = begins ? Number(begins[0].trim().replace(',', '.')) : NaN
      if (!Number.isFinite(x)) throw new Failure(block, 'notANumberText')
      return x + 0
    }
    case 'text_cast_char_toNumber': {
      const [text] = yield* twin.texts(block, 'VALUE')
      const code = text!.charCodeAt(Math.trunc(yield* twin.number(block, 'AT')))
      if (Number.isNaN(code)) throw new Failure(block, 'noSuchLetter')
      return code
    }
    case 'logic_boolean':
      return fieldOf(block, 'BOOL') === 'TRUE'
    case 'logic_null':
      return null
    case 'logic_negate':
      return (yield* twin.ask(block, 'BOOL')) !== true
    case 'logic_operation': {
      const a = (yield* twin.ask(block, 'A')) === true
      if (a === (op === 'OR')) return a
      return (yield* twin.ask(block, 'B')) === true
    }
    case 'logic_ternary':
      return yield* twin.ask(block, (yield* twin.ask(block, 'IF')) === true ? 'THEN' : 'ELSE')
    case 'logic_compare': {
      const [a, b] = [yield* twin.ask(block, 'A'), yield* twin.ask(block, 'B')]
      twin.compared = [a, b]
      if (op === 'EQ' || op === 'NEQ') return same(a, b) === (op === 'EQ')
      return orders[op]!(a as number, b as number)
    }
    case 'text':
      return fieldOf(block, 'TEXT')
    case 'robText_join': {
      const parts: Value[] = []
      for (const input of Object.keys(block.values ?? {})) parts.push(yield* twin.ask(block, input))
      const joined = parts.map(textOf).join('')
      if (joined.length > 10_000) throw new Failure(block, 'textTooLong')
      return joined
    }
    // The tree that the text was printed from is its meaning (rule 32).
    case 'robActions_eval_expr':
      return yield* twin.value(meantBy(block))
    case 'robColour_picker':
      return fieldOf(block, 'COLOUR')
    case 'variables_get':
      return twin.get(block, fieldOf(block, 'VAR'))
    case 'robProcedures_callreturn':
      return yield* twin.call(block)
    case 'robLists_create_with': {
      const list: Value[] = []
      for (const input of Object.keys(block.values ?? {})) list.push(yield* twin.ask(block, input))
      return list
    }
    case 'robLists_repeat': {
      const item = yield* twin.ask(block, 'ITEM')
      const count = Math.max(0, Math.ceil(yield* twin.number(block, 'NUM')))
      if (count > 10_000) throw new Failure(block, 'listTooLong')
      twin.costs(count)
      return Array<Value>(count).fill(item)
    }
    case 'robLists_length':
      return (yield* twin.list(block, 'VALUE')).length
    case 'robLists_isEmpty':
      return (yield* twin.list(block, 'VALUE')).length === 0
    case 'robLists_indexOf': {
      const list = yield* twin.list(block, 'VALUE')
      const wanted = yield* twin.ask(block, 'FIND')
      const places = list.flatMap((entry, k) => (same(entry, wanted) ? [k] : []))
      twin.costs(list.length)
      return (fieldOf(block, 'END') === 'FIRST' ? places[0] : places.at(-1)) ?? -1
    }
    case 'robLists_getIndex':
      return yield* takeEntry(twin, block)
    case 'robLists_getSublist':
      return yield* sublist(twin, block)
    case 'robActions_motor_getPower':
      return twin.host.robot.power(fieldOf(block, 'MOTORPORT') as MotorPort)
    case 'robActions_play_getVolume':
      return twin.host.robot.volume()
    case 'robCommunication_startConnection': {
      const name = textOf(yield* twin.ask(block, 'ADDRESS'))
      const other = twin.host.mail?.find(name) ?? null
      if (other === null) throw new Failure(block, 'noSuchRobot')
      twin.host.mail?.send(other, { kind: 'call', text: '' })
      return other
    }
    case 'robCommunication_waitForConnection':
      return (yield* twin.letter('call', null)).from
    case 'robCommunication_receiveBlock': {
      const from = yield* twin.ask(block, 'CONNECTION')
      if (typeof from !== 'string') throw new Failure(block, 'notConnected')
      return (yield* twin.letter('text', from)).text
    }
    case 'robSensors_get_outputneuron_val':
      return twin.net.outputs.get(fieldOf(block, 'NAME')) ?? 0
    case 'robSensors_get_weight':
      return weightOf(twin, block)
    case 'robSensors_get_bias':
      return biasOf(twin, block)
    default:
      throw new Failure(block, 'unknownBlock')
  }
}
