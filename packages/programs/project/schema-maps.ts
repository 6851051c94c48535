import * as v from 'valibot'
import {
  covers,
  dresses,
  mostOfMap as most,
  mostOfRooms,
  paper,
  type MapDocument,
  type RoadMap,
} from '../map-document.ts'
import { finite } from './schema-program.ts'

/** Also a part of an address and of a block's field. */
const mapId = v.pipe(v.string(), v.regex(/^[a-z0-9]+(-[a-z0-9]+)*$/), v.maxLength(most.name))
const name = v.pipe(v.string(), v.maxLength(most.name))
const x = v.pipe(finite, v.minValue(0), v.maxValue(paper.width))
const y = v.pipe(finite, v.minValue(0), v.maxValue(paper.height))
const reward = v.exactOptional(v.pipe(finite, v.minValue(-100), v.maxValue(100)))
const index = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(most.stations - 1))

/** A JPEG begins with FF D8 FF. */
const photo = v.pipe(v.string(), v.maxLength(most.photo), v.regex(/^\/9j\/[A-Za-z0-9+/]*={0,2}$/))

const station = v.object({ x, y, name: v.exactOptional(name), reward })
const road = v.object({
  ...{ from: index, to: index },
  bends: v.pipe(v.array(v.object({ x, y })), v.maxLength(most.bends)),
  oneWay: v.exactOptional(v.literal(true)),
  closed: v.exactOptional(v.picklist(['both', 'there', 'back'])),
  reward,
  slip: v.exactOptional(v.pipe(finite, v.minValue(0), v.maxValue(1))),
})

const parts = v.object({
  ...{ kind: v.literal('roads'), name, dress: v.picklist(dresses) },
  cover: v.exactOptional(v.picklist(covers)),
  photo: v.exactOptional(photo),
  stations: v.pipe(v.array(station), v.maxLength(most.stations)),
  roads: v.pipe(v.array(road), v.maxLength(most.roads)),
  start: index,
  goals: v.pipe(v.array(index), v.minLength(1), v.maxLength(most.stations)),
  endless: v.exactOptional(v.literal(true)),
  stepCost: v.exactOptional(v.pipe(finite, v.minValue(-100), v.maxValue(100))),
  lengthCounts: v.exactOptional(v.literal(true)),
})

/** Two roads may join the same stations only where each leads one way. A photo lies under the dress `photo`, and no other. */
const isSound = ({ stations, roads, start, goals, dress, photo }: v.InferOutput<typeof parts>) => {
  const inside = (station: number) => station < Math.max(1, stations.length)
  const ways = roads.flatMap(({ from, to, oneWay }) => [
    `${from}-${to}`,
    ...(oneWay ? [] : [`${to}-${from}`]),
  ])
  return (
    [start, ...goals, ...roads.flatMap(({ from, to }) => [from, to])].every(inside) &&
    roads.every(({ from, to }) => from !== to) &&
    new Set(ways).size === ways.length &&
    (dress === 'photo') === (photo !== undefined)
  )
}

const roadSchema: v.GenericSchema<unknown, RoadMap> = v.pipe(
  parts,
  v.check(
    isSound,
    'A road, the start or a goal of the map leads to a station that is not there, or its photo is missing.',
  ),
)

const rooms = v.object({
  ...{ kind: v.literal('rooms'), name },
  rows: v.pipe(
    v.array(v.pipe(v.string(), v.regex(/^[SGFWHI]+$/))),
    v.minLength(2),
    v.maxLength(mostOfRooms.side),
  ),
  wind: v.exactOptional(
    v.array(v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(mostOfRooms.wind))),
  ),
})

/** Rows are equally long; there is one start, and a goal at least. */
const isGrid = ({ rows, wind }: v.InferOutput<typeof rooms>) => {
  const columns = rows[0]!.length
  const letters = rows.join('')
  return (
    columns >= 2 &&
    columns <= mostOfRooms.side &&
    rows.every(({ length }) => length === columns) &&
    letters.split('S').length === 2 &&
    letters.includes('G') &&
    (wind === undefined || wind.length === columns)
  )
}

const mapSchema: v.GenericSchema<unknown, MapDocument> = v.union([
  roadSchema,
  v.pipe(rooms, v.check(isGrid, 'The rooms of the map are no grid with one start and a treasure.')),
])

export const mapsSchema = v.pipe(
  v.record(mapId, mapSchema),
  v.check((maps) => Object.keys(maps).length <= most.maps, `A project has at most ${most.maps} maps.`),
)

/** Does it break no rule of maps? */
export const isMap = (map: unknown): map is MapDocument => v.is(mapSchema, map)
