import type { MapFile } from '@botgarten/maps'
import { make, set } from './svg.ts'
import type { QLearner } from '@botgarten/learning/q-learning'

/** What of a map's own drawing changes: its stations, covers and fog, found once. */
export interface Picture {
  /** Address of an image: scenery and roads never change. */
  readonly scene: string
  /** The same, pale: under what is drawn on it. */
  readonly pale: string
  /** What lies on the roads, and fog. */
  readonly covers: SVGGElement
  /** The stations: over everything that rides. */
  readonly stations: SVGGElement
  /** `worth`: 0..1 by road `a-b`, the better of both directions: how good it is beside the best. */
  cover(visited: readonly boolean[], worth: ReadonlyMap<string, number>): void
  dress(visited: readonly boolean[], active: number | null): void
  /** Height of a station's number, in units of the map. */
  readonly letters: number
  /** Makes stations and their numbers so many times as large as they are drawn. */
  grow(times: number): void
}

/** Takes a map's file apart. It was read before: what it holds is a drawing and nothing else. */
export function takeApart(text: string, { stations: places }: MapFile): Picture {
  const root = document.importNode(
    new DOMParser().parseFromString(text, 'image/svg+xml').documentElement,
    true,
  )
  const covers = make('g')
  covers.append(...layersOf(root, ['covers', 'fog']))
  const stations = root.querySelector<SVGGElement>('#stations')!
  const nodes = [...stations.querySelectorAll<SVGGElement>('[id^=node-]')].map((node, station) =>
    prepareStation(node, places[station]!),
  )
  const roads = [...covers.querySelectorAll('[id^=cover-]')]
  const fog = [...covers.querySelectorAll('[id^=fog-]')]
  const isCity = root.getAttribute('data-map') === 'city'
  return {
    ...{ scene: imageOf(root), pale: imageOf(root, 0.4), covers, stations },
    cover(visited, worth) {
      for (const road of roads) fade(road, worth.get(road.id.slice('cover-'.length)) ?? 0, isCity)
      fog.forEach((patch, station) => set(patch, 'visibility', visited[station] ? 'hidden' : 'visible'))
    },
    dress: (visited, active) =>
      nodes.forEach((node, station) => node.dress(visited[station] ?? false, station === active)),
    letters: Number(stations.getAttribute('font-size') ?? 40),
    grow(times) {
      set(stations, 'font-size', String(this.letters * times))
      for (const node of nodes) node.grow(times)
    },
  }
}

const layersOf = (root: Element, ids: readonly string[]) =>
  ids.flatMap((id) => root.querySelector(`#${id}`) ?? [])

/** A thousand houses and trees are one thing for the browser then. */
function imageOf(root: Element, opacity = 1): string {
  const viewBox = root.getAttribute('viewBox') ?? ''
  const [, , width = '1600', height = '1000'] = viewBox.split(' ')
  const image = make('svg', { viewBox, width, height })
  const layers = make('g', { opacity })
  layers.append(...layersOf(root, ['scenery', 'roads']).map((layer) => layer.cloneNode(true)))
  image.append(layers)
  return `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(image))}`
}

const colours = { visited: '#1F7A45', unvisited: '#C23A30', active: '#1F67B3' }

/** What of a station changes. */
interface StationLook {
  dress(visited: boolean, active: boolean): void
  grow(times: number): void
}

/**
 * Prepares the drawing of a station at a place. What is moved by a transformation is a part of its own for the browser,
 * in every frame: its circles go to their place instead.
 */
function prepareStation(
  node: SVGGElement,
  { x, y }: { readonly x: number; readonly y: number },
): StationLook {
  node.removeAttribute('transform')
  for (const part of node.querySelectorAll('circle')) move(part, 'c', x, y)
  for (const part of node.querySelectorAll('text')) move(part, '', x, y)
  const [disc, ring] = ['.disc', '.ring'].map((part) => node.querySelector(part))
  const radius = Number(disc?.getAttribute('r') ?? 40)
  const halo = make('circle', {
    ...{ cx: x, cy: y, r: radius * 1.27 },
    ...{ fill: '#fff', stroke: colours.active, 'stroke-width': 5 },
  })
  node.insertBefore(halo, disc!)
  const tick = make('g')
  node.append(tick)
  const circles = [...node.querySelectorAll('circle')].map((one) => ({
    one,
    r: Number(one.getAttribute('r')),
  }))
  const words = [...node.querySelectorAll('text')].map((one) => ({
    one,
    aside: Number(one.getAttribute('x')) - x,
    below: Number(one.getAttribute('y')) - y,
  }))
  const grow = (times: number) => {
    for (const { one, r } of circles) set(one, 'r', String(r * times))
    for (const { one, aside, below } of words) {
      set(one, 'x', String(x + aside * times))
      set(one, 'y', String(y + below * times))
    }
    const off = radius * times * 0.78
    tick.replaceChildren(...tickAt(x + off, y - off, radius / 40))
  }
  grow(1)
  return {
    grow,
    /** Colour and form: not yet a dashed ring, visited a whole one and a tick, active a halo. */
    dress(visited, active) {
      set(disc!, 'fill', active ? colours.active : visited ? colours.visited : colours.unvisited)
      set(ring!, 'stroke-dasharray', visited || active ? 'none' : '10 8')
      set(halo, 'visibility', active ? 'visible' : 'hidden')
      set(tick, 'visibility', visited && !active ? 'visible' : 'hidden')
    },
  }
}

function move(part: Element, prefix: 'c' | '', x: number, y: number): void {
  part.setAttribute(`${prefix}x`, String(Number(part.getAttribute(`${prefix}x`) ?? 0) + x))
  part.setAttribute(`${prefix}y`, String(Number(part.getAttribute(`${prefix}y`) ?? 0) + y))
}

function tickAt(x: number, y: number, size: number): readonly SVGElement[] {
  const round = { 'stroke-linecap': 'round', 'stroke-linejoin': 'round', fill: 'none' }
  return [
    make('circle', {
      ...{ cx: x, cy: y, r: 14 * size },
      ...{ fill: '#fff', stroke: '#4A3428', 'stroke-width': 3 * size },
    }),
    make('path', {
      ...round,
      ...{ d: `M${x - 6 * size} ${y}l${4.5 * size} ${5 * size} ${8 * size} ${-9 * size}` },
      ...{ stroke: '#1F7A45', 'stroke-width': 4 * size },
    }),
  ]
}

/** A hedge may always be seen through a little, so that nobody loses the map. */
const THINNEST = 0.06

/**
 * Lets the cover of a road fade; `worth` 0..1. Forest and Mars: the cover itself. City: litter first, then the tone. A
 * cover is one path: fading its fill and its stroke is as good as fading it as a group, which would be a layer of its own
 * in every frame.
 */
function fade(cover: Element, worth: number, isCity: boolean): void {
  const clean = isCity && worth >= 0.98
  const late = clean ? 0 : Math.max(THINNEST, isCity ? Math.min(1, 2 - worth * 2) : 1 - worth)
  set(cover, 'fill-opacity', late.toFixed(2))
  set(cover, 'stroke-opacity', (isCity ? Math.max(0, 1 - worth * 2) : late).toFixed(2))
}

/** How good each road is, 0..1 beside the best: of both directions the better one. By `a-b`, a < b. */
export function worthOf(
  { from, meant }: QLearner['world'],
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
