import type { Learner } from '@botgarten/learning/q-learning'

/** What of a map's own drawing changes: its stations, covers and fog, found once. */
export interface Picture {
  /** Scenery, roads, covers, fog and paths. */
  readonly under: SVGGElement
  /** The stations: over everything that rides. */
  readonly stations: SVGGElement
  show(look: PictureLook): void
}

interface PictureLook {
  readonly visited: readonly boolean[]
  readonly active: number | null
  /** 0..1 by road `a-b`, the better of both directions: how good it is beside the best. */
  readonly worth: ReadonlyMap<string, number>
}

const drawn = 'http://www.w3.org/2000/svg'
const colours = { visited: '#1F7A45', unvisited: '#C23A30', active: '#1F67B3' }
/** A hedge may always be seen through a little, so that nobody loses the map. */
const THINNEST = 0.06

/** Takes a map's file apart. It was read before: what it holds is a drawing and nothing else. */
export function takeApart(text: string): Picture {
  const root = document.importNode(
    new DOMParser().parseFromString(text, 'image/svg+xml').documentElement,
    true,
  )
  const under = document.createElementNS(drawn, 'g')
  for (const id of ['scenery', 'roads', 'covers', 'fog', 'paths']) {
    const layer = root.querySelector(`#${id}`)
    if (layer) under.append(layer)
  }
  under.querySelector('#paths')?.setAttribute('display', 'none')
  const stations = root.querySelector<SVGGElement>('#stations')!
  const nodes = [...stations.querySelectorAll<SVGGElement>('[id^=node-]')].map(prepare)
  const covers = [...under.querySelectorAll<SVGGElement>('[id^=cover-]')]
  const fog = [...under.querySelectorAll<SVGGElement>('[id^=fog-]')]
  const isCity = root.getAttribute('data-map') === 'city'
  return {
    under,
    stations,
    show({ visited, active, worth }) {
      nodes.forEach((node, station) => dress(node, visited[station] ?? false, station === active))
      for (const cover of covers) fade(cover, worth.get(cover.id.slice('cover-'.length)) ?? 0, isCity)
      fog.forEach((patch, station) => patch.setAttribute('opacity', visited[station] ? '0' : '1'))
    },
  }
}

interface Node {
  readonly disc: Element | null
  readonly ring: Element | null
  readonly halo: Element
  readonly tick: Element
}

function prepare(node: SVGGElement): Node {
  const disc = node.querySelector('.disc')
  const radius = Number(disc?.getAttribute('r') ?? 40)
  const halo = document.createElementNS(drawn, 'circle')
  halo.setAttribute('r', String(radius * 1.27))
  halo.setAttribute('fill', '#fff')
  halo.setAttribute('stroke', colours.active)
  halo.setAttribute('stroke-width', '5')
  node.insertBefore(halo, disc)
  const tick = document.createElementNS(drawn, 'g')
  const at = radius * 0.78
  tick.setAttribute('transform', `translate(${at} ${-at}) scale(${radius / 40})`)
  tick.innerHTML =
    '<circle r="14" fill="#fff" stroke="#4A3428" stroke-width="3"/><path d="M-6 0l4.500 5 8-9" fill="none" stroke="#1F7A45" stroke-width="4" stroke-linecap="round" stroke-linejoin="round"/>'
  node.append(tick)
  return { disc, ring: node.querySelector('.ring'), halo, tick }
}

/** Colour and form: not yet a dashed ring, visited a whole one and a tick, active a halo. */
function dress({ disc, ring, halo, tick }: Node, visited: boolean, active: boolean): void {
  disc?.setAttribute('fill', active ? colours.active : visited ? colours.visited : colours.unvisited)
  if (visited || active) ring?.removeAttribute('stroke-dasharray')
  else ring?.setAttribute('stroke-dasharray', '10 8')
  halo.setAttribute('display', active ? 'inline' : 'none')
  tick.setAttribute('display', visited && !active ? 'inline' : 'none')
}

/** Forest and Mars: the cover itself fades. City: litter first, then the tone. */
function fade(cover: SVGGElement, worth: number, isCity: boolean): void {
  const early = Math.max(0, 1 - worth * 2)
  const late = Math.max(THINNEST, isCity ? Math.min(1, 2 - worth * 2) : 1 - worth)
  if (isCity) cover.setAttribute('stroke-opacity', early.toFixed(3))
  cover.setAttribute('opacity', (worth >= 0.98 && isCity ? 0 : late).toFixed(3))
}

/** How good each road is, 0..1 beside the best: of both directions the better one. By `a-b`, a < b. */
export function worthOf(
  { from, meant }: Learner['world'],
  q: ArrayLike<number>,
): ReadonlyMap<string, number> {
  let highest = 0
  for (let move = 0; move < q.length; move++) highest = Math.max(highest, q[move]!)
  const worth = new Map<string, number>()
  for (let move = 0; highest > 0 && move < q.length; move++) {
    const [a, b] = [from[move]!, meant[move]!]
    const name = a < b ? `${a}-${b}` : `${b}-${a}`
    // A root: what is four sections from the goal shall be seen too.
    const share = Math.sqrt(Math.max(0, q[move]!) / highest)
    worth.set(name, Math.max(worth.get(name) ?? 0, share))
  }
  return worth
}
