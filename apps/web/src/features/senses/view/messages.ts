import { colours } from '@botgarten/blocks'
import type { Action, Sensor, TableBrain, TryTrace } from '@botgarten/learning/q-senses'
import { COLOURS, type RobotConfig } from '@botgarten/simulation'
import type { Row } from '../model/table.ts'
import { writeNumber } from '@botgarten/messages'
import { language } from '#words/language.svelte.ts'
import { message, m } from '#words/message.ts'

/** A number with at least and at most so many places. */
const written = (value: number, least: number, most: number): string =>
  writeNumber(value, language.locale, { least, most })

/** With always so many places, so that nothing jumps. */
export const fixed = (value: number, places: number): string => written(value, places, places)

/** With as many places as it needs, three at most. */
const exact = (value: number): string => written(value, 0, 3)

/** Behind a sign of arithmetic. */
const inSum = (text: string) => (text.startsWith('−') ? `(${text})` : text)

const aside = (y: number) => (y > 1 ? 'left' : y < -1 ? 'right' : 'middle')

function plainName({ port, mode }: Sensor, { sensors }: RobotConfig): string {
  return mode === 'distance' ? m[`senses.eye.${aside(sensors[port]?.y ?? 0)}`]() : m[`senses.${mode}`]()
}

/** What the columns of the table are called; of two alike the port says which. */
export function sensorNames(
  { sensors }: Pick<TableBrain, 'sensors'>,
  config: RobotConfig,
): readonly string[] {
  const names = sensors.map((sensor) => plainName(sensor, config))
  const isTwice = (name: string) => names.filter((one) => one === name).length > 1
  return names.map((name, k) => (isTwice(name) ? m['senses.atPort']({ name, port: sensors[k]!.port }) : name))
}

const order = Object.values(COLOURS) as readonly string[]

/** Names of a sensor's buckets by how many there are; those between the first and the last are in the middle. */
function bucketName(mode: Sensor['mode'], bucket: number, last: number): string {
  if (mode === 'colour')
    return message(`choice.${colours.find(({ value }) => value === order[bucket])?.words ?? 'black'}`)
  if (mode === 'touch') return bucket === 0 ? m['senses.free']() : m['senses.pressed']()
  if (last === 0) return m['senses.any']()
  const light = mode === 'light'
  if (bucket === 0) return light ? m['senses.dark']() : m['senses.near']()
  if (bucket === last) return light ? m['senses.bright']() : m['senses.far']()
  return m['senses.between']()
}

/** A row's buckets in words, sensor by sensor; one word for the bump. */
export const bucketNames = (
  { sensors, edges }: Pick<TableBrain, 'sensors' | 'edges'>,
  { buckets }: Row,
): readonly string[] =>
  buckets?.map((bucket, k) => bucketName(sensors[k]!.mode, bucket, edges[k]!.length)) ?? [m['senses.bump']()]

export const stateName = (table: TableBrain, row: Row): string => bucketNames(table, row).join(', ')

const known: readonly (readonly [left: number, right: number, words: string])[] = [
  [50, 50, 'tryAhead'],
  [-25, 25, 'tryLeft'],
  [25, -25, 'tryRight'],
  [-40, -40, 'tryBack'],
  [0, 0, 'tryStop'],
]

const lampWords = { green: 'tryGreen', orange: 'tryOrange', red: 'tryRed', off: 'tryDark' } as const

export function actionName({ left, right, lamp }: Action): string {
  const chip = known.find(([a, b]) => a === left && b === right)
  const wheels = { left: exact(left), right: exact(right) }
  const name = chip ? message(`choice.${chip[2]}`) : m['senses.wheels'](wheels)
  return lamp ? m['senses.lamp']({ name, lamp: message(`choice.${lampWords[lamp]}`) }) : name
}

/** The update with its numbers, as far as it is no more than its last number. */
export const sumOf = ({ before, alpha, reward, bestNext, after }: TryTrace, gamma: number, places = 2) => {
  const text = (value: number) => inSum(fixed(value, places))
  return m['senses.sum']({
    ...{
      before: fixed(before, places),
      same: text(before),
      alpha: exact(alpha),
      reward: fixed(reward, places),
    },
    ...{ gamma: exact(gamma), best: text(bestNext), after: fixed(after, places) },
  })
}

/** `3 × 3 + bump = 10 states`. */
export function sizeSentence({
  buckets,
  bump,
  states,
}: {
  buckets: readonly number[]
  bump: boolean
  states: number
}) {
  const product = buckets.join(' × ')
  return bump ? m['senses.sizeBump']({ product, states }) : m['senses.size']({ product, states })
}
