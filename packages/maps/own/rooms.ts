import { mostOfRooms as most, type RoomMap } from '@botgarten/programs'
import { attributes, ink, layer, stationDrawn } from './layers.ts'
import { ownId } from './own-id.ts'

/** cm of the robot's world from the middle of a room to that of the next: the shortest that it turns in. */
const ROOM = 40

const colours: { readonly [letter: string]: string } = {
  ...{ S: '#EDF0DC', G: '#FFF0C2', F: '#EDF0DC', H: '#DCC7A5', W: '#B98B6A', I: '#D5EAF0' },
}

/** What stands in a room, around its middle, in a room of 100 units. */
export const furniture: { readonly [letter: string]: string } = {
  H: '<ellipse cy="4" rx="34" ry="24" fill="#3A2A20"/><path d="M-34 4a34 24 0 0 1 68 0" fill="none" stroke="#8C7152" stroke-width="5"/>',
  W: '<path d="M-44 -16h88M-44 16h88M0 -44v28M-24 -16v32M24 -16v32M0 16v28" stroke="#8C5F44" stroke-width="4"/>',
  G: '<g stroke="#4A3428" stroke-width="4" stroke-linejoin="round"><path d="M-27 -4v26h54v-26z" fill="#C98042"/><path d="M-27 -4c0 -24 54 -24 54 0z" fill="#E0A066"/><path d="M-6 -8h12v12h-12z" fill="#FFC83D"/></g>',
  I: '<path d="M-34 -8l18 -24M-26 6l32 -42M14 38l24 -32" stroke="#FFFFFF" stroke-width="6" stroke-linecap="round"/>',
}

/** How hard it blows, as so many arrows upwards. */
export const windArrows = (strength: number): string =>
  Array.from({ length: strength }, (_, index) => {
    const x = (index - (strength - 1) / 2) * 26
    return `<path d="M${x} 22v-44m-9 11l9 -11 9 11" fill="none" stroke="#7FA9B8" stroke-width="5" stroke-linecap="round" stroke-linejoin="round"/>`
  }).join('')

export const colourOf = (letter: string): string => colours[letter] ?? colours['F']!

/** Where the rooms of a map lie: sides and middles in units of its drawing, row by row. */
export function roomPlaces({ rows }: Pick<RoomMap, 'rows'>) {
  const columns = rows[0]!.length
  const side = rows.length * 1.2 > columns ? 1000 / rows.length : 1600 / columns
  const places = [...rows.join('')].map((_, room) => ({
    x: ((room % columns) + 0.5) * side,
    y: (Math.floor(room / columns) + 0.5) * side,
  }))
  return { side, places, width: columns * side, height: rows.length * side }
}

/** The rooms alone, as an SVG: without stations. */
export const roomsDrawn = (map: RoomMap): string => {
  const { width, height } = roomPlaces(map)
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">${tilesOf(map)}</svg>`
}

function tilesOf(map: RoomMap): string {
  const { rows, wind } = map
  const { side, places } = roomPlaces(map)
  const letters = [...rows.join('')]
  const inner = side - 8
  const tiles = places.map(({ x, y }, room) => {
    const letter = letters[room]!
    const blows = 'WHG'.includes(letter) ? 0 : (wind?.[room % rows[0]!.length] ?? 0)
    const tile = `<rect x="${-inner / 2}" y="${-inner / 2}" width="${inner}" height="${inner}" rx="${side / 9}" fill="${colourOf(letter)}" stroke="${ink}" stroke-opacity=".5" stroke-width="4"/>`
    return `<g transform="translate(${x} ${y})">${tile}<g transform="scale(${side / 100})">${furniture[letter] ?? ''}${windArrows(blows)}</g></g>`
  })
  return tiles.join('')
}

/** A map of rooms as an SVG like those that everybody has: its letters at the root, a station a room. */
export function writeRooms(map: RoomMap, id: string): string {
  const { rows, wind } = map
  const { side, places, width, height } = roomPlaces(map)
  const font = `font-family="'Baloo 2', Nunito, sans-serif" font-weight="800" font-size="${side / 5}" text-anchor="middle"`
  const root = attributes({
    ...{ map: ownId(id), name: map.name, rooms: '', grid: rows.join('/'), wind: wind?.join(' ') },
    'cm-per-unit': ROOM / side,
  })
  const stations = places.map((place, room) => stationDrawn(place, room, { radius: side / 5 }))
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}"${root}>`,
    layer('scenery', [`<rect width="${width}" height="${height}" fill="#FBF5EA"/>`, tilesOf(map)]),
    ...['roads', 'covers', 'paths'].map((name) => `<g id="${name}"/>`),
    layer('stations', stations, font),
    '</svg>',
    '',
  ].join('\n')
}

// ---- editing ----

export const roomKinds = ['floor', 'wall', 'trap', 'ice', 'wind', 'treasure', 'start'] as const
export type RoomKind = (typeof roomKinds)[number]
/** The letter of a room's kind. */
export const letterOf = { floor: 'F', wall: 'W', trap: 'H', ice: 'I', treasure: 'G', start: 'S' } as const

/** What is in a room, wind aside. */
export const kindOf = (letter: string): Exclude<RoomKind, 'wind'> =>
  (Object.entries(letterOf).find(([, one]) => one === letter)?.[0] ?? 'floor') as Exclude<RoomKind, 'wind'>

/** Rooms of floor, a start in one corner and a treasure in the other. */
export function emptyRooms(name: string, columns = 4, rows = 4): RoomMap {
  const map = { kind: 'rooms', name, rows: Array.from({ length: rows }, () => 'F'.repeat(columns)) } as const
  return laid(laid(map, 0, 'S'), columns * rows - 1, 'G')
}

const laid = (map: RoomMap, room: number, letter: string): RoomMap => {
  const columns = map.rows[0]!.length
  const [row, column] = [Math.floor(room / columns), room % columns]
  const rows = map.rows.with(row, map.rows[row]!.slice(0, column) + letter + map.rows[row]!.slice(column + 1))
  return { ...map, rows }
}

const count = ({ rows }: RoomMap, letter: string) => rows.join('').split(letter).length - 1

/**
 * Makes something of a room; what is there already becomes floor again. Wind blows through the whole column, by one more
 * up to 2. The same map where the start or the last treasure would be gone.
 */
export function setRoom(map: RoomMap, room: number, kind: RoomKind): RoomMap {
  const columns = map.rows[0]!.length
  if (kind === 'wind') return blown(map, room % columns)
  const before = map.rows.join('')[room]!
  const letter = before === letterOf[kind] ? 'F' : letterOf[kind]
  const isLast = before === 'S' || (before === 'G' && count(map, 'G') === 1)
  if (isLast || before === letter) return map
  const start = map.rows.join('').indexOf('S')
  return laid(kind === 'start' ? laid(map, start, 'F') : map, room, letter)
}

function blown({ wind: before, ...map }: RoomMap, column: number): RoomMap {
  const wind = (before ?? map.rows[0]!.replace(/./g, '0').split('').map(Number)).with(
    column,
    ((before?.[column] ?? 0) + 1) % 3,
  )
  return wind.some((push) => push > 0) ? { ...map, wind } : map
}

/** More rooms at the right and below, or fewer: start and treasure stay on the map. */
export function resizeRooms({ wind, ...map }: RoomMap, columns: number, rows: number): RoomMap {
  const within = (value: number) => Math.min(most.side, Math.max(2, value))
  const [wide, high] = [within(columns), within(rows)]
  const grown = Array.from({ length: high }, (_, row) =>
    (map.rows[row] ?? '').slice(0, wide).padEnd(wide, 'F'),
  )
  const blows = wind && Array.from({ length: wide }, (_, column) => wind[column] ?? 0)
  const all: RoomMap = { ...map, rows: grown, ...(blows?.some((push) => push > 0) && { wind: blows }) }
  const free = (room: number, step: number): number =>
    all.rows.join('')[room] === 'G' ? free(room + step, step) : room
  const begun = count(all, 'S') === 1 ? all : laid(all, free(0, 1) % (wide * high), 'S')
  const last = wide * high - 1
  return count(begun, 'G') > 0 ? begun : laid(begun, begun.rows.join('')[last] === 'S' ? last - 1 : last, 'G')
}

/** Room numbers of start and treasures. */
export function endsOf({ rows }: RoomMap): { readonly start: number; readonly goals: readonly number[] } {
  const letters = [...rows.join('')]
  return {
    start: letters.indexOf('S'),
    goals: letters.flatMap((letter, room) => (letter === 'G' ? [room] : [])),
  }
}
