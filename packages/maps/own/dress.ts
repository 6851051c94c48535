import { paper, type Cover, type Dress, type RoadMap } from '@botgarten/programs'
import { pointsAlong, segmentsOf } from '../path.ts'
import { distance, type Point } from '../point.ts'

const ink = '#4A3428'

/** One stroke of a road; those of a road lie on each other, the first lowest. */
export interface Stroke {
  readonly colour: string
  /** Units. */
  readonly width: number
  readonly dash?: string
}

interface Look {
  readonly ground: string
  /** Patches that lie on the ground. */
  readonly patches: string
  readonly road: readonly Stroke[]
  /** What stands beside the roads, around 0 0; about 90 units high and wide. */
  readonly things: readonly string[]
}

const outlined = `stroke="${ink}" stroke-width="5" stroke-linejoin="round" stroke-linecap="round"`
const tree = `<g ${outlined}><path d="M0 10v32" stroke-width="9"/><circle cy="-10" r="32" fill="#8CC265"/></g>`
const fir = `<g ${outlined}><path d="M0 24v20" stroke-width="9"/><path d="M0 -46l-24 36h12l-20 34h64l-20 -34h12z" fill="#6CA86C"/></g>`
const grass =
  '<path d="M-12 8q-2 -12 -8 -16M0 8v-20M12 8q2 -12 8 -16" fill="none" stroke="#8CB765" stroke-width="5" stroke-linecap="round"/>'
const house = (roof: string) =>
  `<g ${outlined}><path d="M-32 -4h64v42h-64z" fill="#FFF1D6"/><path d="M-42 -2l42 -38 42 38z" fill="${roof}"/><path d="M6 12h16v26h-16z" fill="#B0673A"/><path d="M-22 8h16v16h-16z" fill="#A9D8E2"/></g>`
const tower = `<g ${outlined}><path d="M-26 -44h52v86h-52z" fill="#E9D7B4"/><path d="M-14 -32h10v12h-10zM6 -32h10v12h-10zM-14 -8h10v12h-10zM6 -8h10v12h-10z" fill="#A9D8E2" stroke-width="3"/><path d="M-8 18h16v24h-16z" fill="#B0673A"/></g>`
const crater = `<g ${outlined}><ellipse rx="40" ry="24" fill="#C47E5E"/><ellipse cy="4" rx="24" ry="12" fill="#A8664A" stroke-width="3"/></g>`
const rock = `<path d="M-32 24l8 -34 22 -14 26 16 10 32z" fill="#B9755A" ${outlined}/>`
const wave =
  '<path d="M-30 0q10 -12 20 0t20 0 20 0" fill="none" stroke="#6FB3C4" stroke-width="5" stroke-linecap="round"/>'
const isle = `<g ${outlined}><ellipse cy="20" rx="42" ry="16" fill="#F1DEA8"/><path d="M0 20q6 -30 2 -50" fill="none" stroke-width="8"/><path d="M2 -30q-26 -12 -34 10q18 -8 34 -10q26 -12 34 10q-18 -8 -34 -10" fill="#7CC257"/></g>`
const boat = `<g ${outlined}><path d="M-30 16h60l-12 20h-36z" fill="#CC3F24"/><path d="M0 14v-50l26 42z" fill="#FFFDF8"/></g>`
const signal = `<g ${outlined}><path d="M0 42v-60" stroke-width="7"/><rect x="-13" y="-46" width="26" height="42" rx="10" fill="#6B5545"/><circle cy="-34" r="7" fill="#E4604A" stroke="none"/><circle cy="-16" r="7" fill="#7CC257" stroke="none"/></g>`

const hills = (colour: string) =>
  `<path d="M0 0h1600v90Q1200 30 900 100T0 110z" fill="${colour}"/><path d="M900 1000Q1150 900 1600 950v50z" fill="${colour}"/>`

const looks: { readonly [dress in Dress]: Look } = {
  meadow: {
    ground: '#E7EFCD',
    patches: hills('#D8E7B4'),
    road: [{ colour: ink, width: 52 }, { colour: '#F5DFBB', width: 42 }, { colour: '#C9A976', width: 4, dash: '16 20' }], // prettier-ignore
    things: [tree, grass, fir, tree, house('#D9603F'), grass],
  },
  town: {
    ground: '#EFE7D6',
    patches: '<path d="M0 860h1600v140H0z" fill="#E2D6BC"/><path d="M1180 0h420v220h-420z" fill="#DCE9C2"/>',
    road: [{ colour: ink, width: 54 }, { colour: '#B9B2A6', width: 44 }, { colour: '#FFFDF8', width: 4, dash: '24 20' }], // prettier-ignore
    things: [house('#D9603F'), tower, house('#6F55C4'), tree, house('#2F8FA0'), tower],
  },
  railway: {
    ground: '#EAEFCF',
    patches: hills('#DDE6B9'),
    road: [{ colour: '#8C7152', width: 46, dash: '9 19' }, { colour: ink, width: 30 }, { colour: '#EAEFCF', width: 18 }], // prettier-ignore
    things: [fir, grass, signal, tree, fir, grass],
  },
  mars: {
    ground: '#E9B596',
    patches: hills('#DEA281'),
    road: [{ colour: '#7C432E', width: 52 }, { colour: '#F6D6BD', width: 42 }, { colour: '#C98F6C', width: 4, dash: '4 22' }], // prettier-ignore
    things: [rock, crater, rock, crater, rock, rock],
  },
  sea: {
    ground: '#BFE1E8',
    patches: hills('#AFD7E0'),
    road: [{ colour: '#3E7D8E', width: 52 }, { colour: '#E4F4F6', width: 42 }, { colour: '#3E7D8E', width: 6, dash: '2 22' }], // prettier-ignore
    things: [wave, isle, wave, boat, wave, wave],
  },
  paper: {
    ground: '#FFFDF8',
    patches: '',
    road: [
      { colour: ink, width: 44 },
      { colour: '#FFFDF8', width: 34 },
    ],
    things: [],
  },
  photo: {
    ground: '#FFFDF8',
    patches: '',
    road: [{ colour: ink, width: 50 }, { colour: '#F7E6C8', width: 40 }, { colour: '#C9A976', width: 4, dash: '16 20' }], // prettier-ignore
    things: [],
  },
}

/** What lies on a road that nobody has found good yet. */
export const coverStrokes: { readonly [cover in Cover]: Stroke } = {
  hedge: { colour: '#98C077', width: 58 },
  dirt: { colour: '#BCA688', width: 46 },
  fog: { colour: '#E6E3DA', width: 62 },
}

export const strokesOf = (dress: Dress): readonly Stroke[] => looks[dress].road

/** Between two places where something may stand: units. */
const GRID = 130
/** So far from a road and from a station, at least. */
const CLEAR = { road: 82, station: 120 }

/** The photo of a map as an address. */
export const photoAddress = (photo: string): string => `data:image/jpeg;base64,${photo}`

/** Ground and all that stands beside the roads, as markup. The same map has the same scenery. */
export function sceneryOf(map: RoadMap, roads: readonly string[]): string {
  const { ground, patches, things } = looks[map.dress]
  const size = `width="${paper.width}" height="${paper.height}"`
  if (map.photo !== undefined) return `<image ${size} href="${photoAddress(map.photo)}"/>`
  const taken = roads.flatMap((line) => (segmentsOf(line) ?? []).flatMap((one) => pointsAlong(one, 40)))
  const stands = things.length === 0 ? [] : placesFor(map.stations, taken)
  const all = stands.map(
    ({ at, pick }) => `<g transform="translate(${at.x} ${at.y})">${things[pick % things.length]}</g>`,
  )
  return [`<rect ${size} fill="${ground}"/>`, patches, ...all].join('')
}

function placesFor(stations: readonly Point[], roads: readonly Point[]) {
  const places: { at: Point; pick: number }[] = []
  for (let row = 0; row * GRID < paper.height - GRID; row++)
    for (let column = 0; column * GRID < paper.width - GRID; column++) {
      const dice = scrambled(row * 31 + column)
      if (dice % 5 < 2) continue
      const at = { x: 80 + column * GRID + (dice % 61), y: 85 + row * GRID + ((dice >>> 7) % 61) }
      const isFree =
        stations.every((one) => distance(one, at) > CLEAR.station) &&
        roads.every((one) => distance(one, at) > CLEAR.road)
      if (isFree) places.push({ at, pick: dice >>> 12 })
    }
  return places
}

/** A number as a die: multiplied and mixed (Knuth, The Art of Computer Programming, 6.4). */
const scrambled = (seed: number) => {
  const mixed = Math.imul(seed + 1, 2654435761)
  return (mixed ^ (mixed >>> 15)) >>> 0
}
