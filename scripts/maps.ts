// Draws the plain maps of content/maps: the grids, and the roundabout with a reward that invites to cheat.
// Run after a change here: npm run maps
import { mkdirSync, writeFileSync } from 'node:fs'
import { content } from '@botgarten/content/files'

interface Point {
  readonly x: number
  readonly y: number
}

const ink = '#4A3428'

function station(number: number, { x, y }: Point, radius: number, more = ''): string {
  return [
    `<g id="node-${number}" class="station" transform="translate(${x} ${y})"${more}>`,
    `<circle class="shade" cy="${radius / 9}" r="${radius}" fill="#3A2A20" fill-opacity=".25"/>`,
    `<circle class="disc" r="${radius}" fill="#C23A30" stroke="${ink}" stroke-width="6"/>`,
    `<circle class="ring" r="${radius * 0.8}" fill="none" stroke="#FFFFFF" stroke-width="4" stroke-dasharray="10 8"/>`,
    `<text class="number" y="${radius * 0.34}" fill="#FFFFFF">${number}</text></g>`,
  ].join('')
}

const layer = (id: string, content: readonly string[], more = '') =>
  `<g id="${id}"${more}>\n${content.join('\n')}\n</g>`.replace('\n\n', '\n')

function drawing(
  root: string,
  layers: readonly string[],
  size: readonly [number, number],
  radius: number,
): string {
  const font = ` font-family="'Baloo 2', Nunito, sans-serif" font-weight="800" font-size="${radius}" text-anchor="middle"`
  const all = layers.map((one) => one.replace('<g id="stations">', `<g id="stations"${font}>`))
  const head = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size.join(' ')}" ${root}>`
  return [head, ...all, '</svg>', ''].join('\n')
}

const cellColours: { readonly [letter: string]: string } = {
  ...{ S: '#EDF0DC', G: '#FFF0C2', F: '#EDF0DC', H: '#DCC7A5', C: '#6B5545', W: '#B98B6A', P: '#FBE3CF' },
}

/** What stands in a room, around its middle, in a room of 100 units. */
const furniture: { readonly [letter: string]: string } = {
  H: '<ellipse cy="4" rx="34" ry="24" fill="#3A2A20"/><path d="M-34 4a34 24 0 0 1 68 0" fill="none" stroke="#8C7152" stroke-width="5"/>',
  C: '<path d="M-44 -30l12 14 12 -14 12 14 12 -14 12 14 12 -14 12 14 4 -6" fill="none" stroke="#C98F62" stroke-width="5" stroke-linejoin="round"/>',
  W: '<path d="M-44 -16h88M-44 16h88M0 -44v28M-24 -16v32M24 -16v32M0 16v28" stroke="#8C5F44" stroke-width="4"/>',
  P: '<g stroke="#4A3428" stroke-width="4" stroke-linejoin="round"><path d="M-26 -20h52v42h-52z" fill="#E3B36F"/><path d="M-6 -20h12v42h-12z" fill="#FFF6DD"/></g>',
  G: '<g stroke="#4A3428" stroke-width="4" stroke-linejoin="round"><path d="M-27 -4v26h54v-26z" fill="#C98042"/><path d="M-27 -4c0 -24 54 -24 54 0z" fill="#E0A066"/><path d="M-6 -8h12v12h-12z" fill="#FFC83D"/></g>',
}
const arrow = (x: number) =>
  `<path d="M${x} 22v-44m-9 11l9 -11 9 11" fill="none" stroke="#7FA9B8" stroke-width="5" stroke-linecap="round" stroke-linejoin="round"/>`

interface Look {
  /** Letters whose floor has another colour: ice. */
  readonly colours?: typeof cellColours
  readonly wind?: readonly number[]
  readonly cmPerUnit?: number
  /** Drawn twice: who enters the room with the parcel goes on in the second one. */
  readonly floors?: 2
}

function grid(id: string, rows: readonly string[], more: string, look: Look = {}): string {
  const { colours = {}, wind = [], cmPerUnit = 0.3, floors = 1 } = look
  const columns = rows[0]!.length
  const cell = rows.length * 1.2 > columns ? 1000 / rows.length : 1600 / (columns * floors + (floors - 1))
  const hall = columns * cell
  const letters = [...rows.join('')]
  const gap = floors > 1 ? cell : 0
  const at = (index: number): Point => ({
    x: (index >= letters.length ? hall + gap : 0) + ((index % columns) + 0.5) * cell,
    y: (Math.floor((index % letters.length) / columns) + 0.5) * cell,
  })
  const all = Array.from({ length: letters.length * floors }, (_, index) => index)
  const tile = (index: number) => {
    const letter = letters[index % letters.length]!
    const carries = index >= letters.length
    const { x, y } = at(index)
    const side = cell - 8
    const shown = floors > 1 && ((letter === 'P' && carries) || (letter === 'G' && !carries)) ? 'F' : letter
    const fill = colours[shown] ?? cellColours[shown]
    const blows = 'SF'.includes(letter) ? (wind[index % columns] ?? 0) : 0
    const arrows = blows === 2 ? arrow(-14) + arrow(14) : blows === 1 ? arrow(0) : ''
    return `<g transform="translate(${x} ${y})"><rect x="${-side / 2}" y="${-side / 2}" width="${side}" height="${side}" rx="${cell / 9}" fill="${fill}" stroke="${ink}" stroke-opacity=".5" stroke-width="4"/><g transform="scale(${cell / 100})">${furniture[shown] ?? ''}${arrows}</g></g>`
  }
  const width = floors * hall + (floors - 1) * gap
  const height = rows.length * cell
  const lift =
    floors > 1
      ? `<g transform="translate(${hall + cell / 2} ${cell / 2}) scale(${cell / 130})">${furniture['P']}<path d="M-22 44h44m-12 -11l12 11 -12 11" fill="none" stroke="${ink}" stroke-width="5" stroke-linecap="round" stroke-linejoin="round"/></g>`
      : ''
  const floor = `<rect width="${width}" height="${height}" fill="#FBF5EA"/>`
  const root = `data-map="${id}" data-cm-per-unit="${cmPerUnit}" data-grid="${rows.join('/')}" ${more}`
  const radius = cell / 5
  return drawing(
    root,
    [
      layer('scenery', [floor, lift, ...all.map(tile)].filter(Boolean)),
      ...['roads', 'covers', 'paths', 'obstacles'].map((name) => `<g id="${name}"/>`),
      layer(
        'stations',
        all.map((index) => station(index, at(index), radius)),
      ),
    ],
    [width, height],
    radius,
  )
}

/** A ring of six with a market on it: who passes it again and again is paid more than who gets home. */
function roundabout(): string {
  const places: readonly Point[] = [
    ...[
      { x: 200, y: 500 },
      { x: 480, y: 500 },
      { x: 700, y: 240 },
      { x: 1000, y: 240 },
    ],
    ...[
      { x: 1180, y: 500 },
      { x: 940, y: 760 },
      { x: 660, y: 760 },
      { x: 1440, y: 500 },
    ],
  ]
  const roads = [
    ...[
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 4],
      [4, 5],
      [5, 6],
      [6, 1],
      [4, 7],
    ],
  ] as const
  const line = (from: number, to: number) =>
    `M${places[from]!.x} ${places[from]!.y}L${places[to]!.x} ${places[to]!.y}`
  const both = roads.flatMap(([a, b]) => [[a, b] as const, [b, a] as const])
  const wide = (width: number, colour: string) =>
    `<g fill="none" stroke="${colour}" stroke-width="${width}">${roads.map(([a, b]) => `<path d="${line(a, b)}"/>`).join('')}</g>`
  const obstacle = ([a, b]: readonly [number, number]) => {
    const [from, to] = [places[a]!, places[b]!]
    const angle = Math.round((Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI)
    return `<g id="obstacle-${Math.min(a, b)}-${Math.max(a, b)}" transform="translate(${(from.x + to.x) / 2} ${(from.y + to.y) / 2})" data-angle="${angle}"/>`
  }
  const garden = [
    '<rect width="1600" height="1000" fill="#EAEFCF"/>',
    '<circle cx="830" cy="500" r="150" fill="#CFE3B0"/>',
    '<circle cx="830" cy="500" r="70" fill="#A9D8E2" stroke="#4A3428" stroke-opacity=".3" stroke-width="4"/>',
    '<path d="M960 120h80l-10 44h-60zM952 120q14 26 28 0q14 26 28 0q14 26 40 0" fill="#F28C45" stroke="#4A3428" stroke-width="4"/>',
  ]
  const root = 'data-map="roundabout" data-cm-per-unit="0.2" data-start="0" data-goal="7"'
  return drawing(
    root,
    [
      layer('scenery', garden),
      layer('roads', [wide(54, ink), wide(46, '#F5EBDA')], ' stroke-linecap="round" stroke-linejoin="round"'),
      '<g id="covers"/>',
      layer(
        'paths',
        both.map(([a, b]) => `<path id="path-${a}-${b}" d="${line(a, b)}"/>`),
        ' fill="none" stroke="none"',
      ),
      layer('obstacles', roads.map(obstacle)),
      layer(
        'stations',
        places.map((place, index) => station(index, place, 46, index === 3 ? ' data-reward="30"' : '')),
      ),
    ],
    [1600, 1000],
    46,
  )
}

const ice = { S: '#DCEBEE', F: '#DCEBEE', H: '#BFD9DF' }
const lake = (id: string, rows: readonly string[]) =>
  grid(id, rows, 'data-surefooted="0.3333333333333333" data-goal-reward="1"', { colours: ice })
/** Sutton & Barto, 2nd edition, example 6.5. */
const wind = [0, 0, 0, 1, 1, 1, 2, 2, 1, 0]

const maps: { readonly [id: string]: string } = {
  lake: lake('lake', ['SFFF', 'FHFH', 'FFFH', 'HFFG']),
  'lake-8': lake('lake-8', [
    ...['SFFFFFFF', 'FFFFFFFF', 'FFFHFFFF', 'FFFFFHFF'],
    ...['FFFHFFFF', 'FHHFFFHF', 'FHFFHFHF', 'FFFHFFFG'],
  ]),
  windy: grid(
    'windy',
    ['FFFFFFFFFF', 'FFFFFFFFFF', 'FFFFFFFFFF', 'SFFFFFFGFF', 'FFFFFFFFFF', 'FFFFFFFFFF', 'FFFFFFFFFF'],
    `data-wind="${wind.join(' ')}" data-goal-reward="0" data-step-cost="1"`,
    { wind, cmPerUnit: 0.5 },
  ),
  errand: grid('errand', ['FPFG', 'FWWF', 'SFFF'], '', { floors: 2, cmPerUnit: 0.35 }),
  bandit: grid('bandit', ['GSG'], 'data-chances="0.3 0.6"', { cmPerUnit: 0.15 }),
  cliff: grid(
    'cliff',
    ['FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'FFFFFFFFFFFF', 'SCCCCCCCCCCG'],
    'data-cliff-reward="-99" data-goal-reward="0" data-step-cost="1"',
  ),
  roundabout: roundabout(),
}

for (const [id, svg] of Object.entries(maps)) {
  mkdirSync(content.path('maps', id), { recursive: true })
  writeFileSync(content.path('maps', id, 'map.svg'), svg)
  console.log(`${id}: ${svg.length} bytes`)
}
