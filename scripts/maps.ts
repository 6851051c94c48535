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
  ...{ S: '#DFF0E4', G: '#FFF0C2', F: '#E3F1F4', H: '#7FA9B8', C: '#B98B6A', W: '#8C7152' },
}

function grid(id: string, rows: readonly string[], more: string): string {
  const cell = 1600 / rows[0]!.length
  const at = (index: number): Point => ({
    x: ((index % rows[0]!.length) + 0.5) * cell,
    y: (Math.floor(index / rows[0]!.length) + 0.5) * cell,
  })
  const letters = [...rows.join('')]
  const tile = (letter: string, index: number) => {
    const { x, y } = at(index)
    const side = cell - 8
    return `<rect x="${x - side / 2}" y="${y - side / 2}" width="${side}" height="${side}" rx="${cell / 9}" fill="${cellColours[letter]}" stroke="${ink}" stroke-opacity=".25" stroke-width="3"/>`
  }
  const floor = `<rect width="1600" height="${rows.length * cell}" fill="#FBF5EA"/>`
  const root = `data-map="${id}" data-cm-per-unit="0.3" data-grid="${rows.join('/')}" ${more}`
  const radius = cell / 5
  return drawing(
    root,
    [
      layer('scenery', [floor, ...letters.map(tile)]),
      ...['roads', 'covers', 'paths', 'obstacles'].map((name) => `<g id="${name}"/>`),
      layer(
        'stations',
        letters.map((_, index) => station(index, at(index), radius)),
      ),
    ],
    [1600, rows.length * cell],
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

const lake = (id: string, rows: readonly string[]) =>
  grid(id, rows, 'data-surefooted="0.3333333333333333" data-goal-reward="1"')

const maps: { readonly [id: string]: string } = {
  lake: lake('lake', ['SFFF', 'FHFH', 'FFFH', 'HFFG']),
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
