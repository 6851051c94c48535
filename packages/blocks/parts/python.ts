import type { SensorKind } from '@botgarten/simulation'
import { binds, whole, type Expression, type Python, type PythonAt } from '../python.ts'
import type { Block } from '../types.ts'
import { motorPortIn, sensorPortIn } from './fields.ts'
import { numberIn } from './numbers.ts'
import { plugged, rowCount, rowName } from './rows.ts'

/** Another block writes it, or the head of the file. */
export const part: Python = { part: true }
export const missing = (key: string): Python => ({ missing: key })

export const isNumber = (code: string): boolean => /^-?\d+(\.\d+)?$/.test(code)
export const isWhole = (code: string) => /^-?\d+$/.test(code)

/** A place in a list: Python takes whole numbers alone. */
export const placeAt = (py: PythonAt, input: string): string => {
  const code = py.value(input)
  return isWhole(code) ? code : `int(${code})`
}

/** A place by WHERE and AT, as Python counts: from the end below 0. */
export function indexIn(py: PythonAt, where: string, at: string): string {
  const said = py.field(where, 'FROM_START')
  if (said === 'FIRST') return '0'
  if (said === 'LAST') return '-1'
  const place = placeAt(py, at)
  if (said !== 'FROM_END') return place
  return isWhole(place) ? String(-1 - Number(place)) : `-1 - ${place}`
}

/** The place before: groups are counted from 1, lists from 0. */
export const beforeOf = (place: string): string =>
  isWhole(place) ? String(Number(place) - 1) : `${place} - 1`

/** A number as a file writes it; null where it is none. */
export function numberOf(text: string): Expression | null {
  const number = numberIn(text)
  if (number === null) return null
  return { code: String(number), binds: number < 0 ? binds.sign : binds.whole }
}

/** So many times a number, worked out where it is written out. */
export function timesNumber({ code, binds: how }: Expression, factor: number): string {
  if (isNumber(code)) return String(Number(code) * factor)
  return how < binds.product ? `(${code}) * ${factor}` : `${code} * ${factor}`
}

/** Names of the filled rows of a list. */
export const filledNames = (block: Block): readonly string[] =>
  Array.from({ length: rowCount(block) }, (_, k) => rowName(k)).filter((name) => plugged(block, name))

const opposite: ReadonlyMap<string, string> = new Map([
  ['==', '!='],
  ['!=', '=='],
  ['<', '>='],
  ['>=', '<'],
  ['>', '<='],
  ['<=', '>'],
  ['in', 'not in'],
  ['is', 'is not'],
  ['is not', 'is'],
])

export const compared = (a: string, sign: string, b: string): Expression => ({
  ...{ code: `${a} ${sign} ${b}`, binds: binds.compare },
  not: `${a} ${opposite.get(sign)} ${b}`,
})

/** The other sign; of a number written out it is another number. */
export function minus({ code, binds: how }: Expression): string {
  if (isNumber(code)) return Number(code) === 0 ? '0' : code.startsWith('-') ? code.slice(1) : `-${code}`
  return how < binds.sign ? `-(${code})` : `-${code}`
}

export function binary(py: PythonAt, a: string, sign: string, b: string, how: number): Expression {
  return { code: `${py.value(a, how)} ${sign} ${py.value(b, how + 1)}`, binds: how }
}

const secondWays = ['BACKWARD', 'BACKWARDS', 'LEFT']

/** What is plugged in, with the other sign where the block's direction is the second one. */
export const along = (py: PythonAt, input: string): string =>
  secondWays.includes(py.field('DIRECTION')) ? minus(py.expression(input)) : py.value(input)

/** The motor that a field names. */
export const motorIn = (py: PythonAt, field = 'MOTORPORT') =>
  motorPortIn(py.block, field) ?? py.gap('problem.unknownChoice')

/** What a sensor says at the port that a field names. */
export function readIn(py: PythonAt, kind: SensorKind, what: string, field = 'SENSORPORT'): Expression {
  const port = sensorPortIn(py.block, field) ?? py.gap('problem.unknownChoice')
  return py.robot.read(kind, port, what) ?? py.missing(kind)
}

/** A statement that only one robot's library can do. */
export function act(py: PythonAt, code: string | null, missingKey: string): void {
  if (code === null) py.missing(missingKey)
  else py.line(code)
}

/** How often a loop runs, as `range` wants it. */
export function rangeTimes(py: PythonAt, code: string): string {
  return isWhole(code) ? code : `${py.from('math', 'ceil')}(${code})`
}

export const asked = (expression: Expression): string =>
  expression.not ?? (expression.binds < binds.not ? `not (${expression.code})` : `not ${expression.code}`)

/** A function of Python's, or one the file brings along, of the one input. */
export const of = (name: string, input: string) => (py: PythonAt) => whole(py.call(name, py.value(input)))
