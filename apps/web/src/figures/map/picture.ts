import type { MapFile } from '@botgarten/maps'
import { fade } from './covers.ts'
import { prepareStation } from './stations.ts'
import { make, set } from './svg.ts'

/** What of a map's own drawing changes: its stations, covers and fog, found once. */
export interface Picture {
  /** Address of an image: scenery and roads never change. */
  readonly scene: string
  /** What lies on the roads, and fog. */
  readonly covers: SVGGElement
  /** The stations: over everything that rides. */
  readonly stations: SVGGElement
  /** `worth`: 0..1 by road `a-b`, the better of both directions: how good it is beside the best. */
  cover(visited: readonly boolean[], worth: ReadonlyMap<string, number>): void
  dress(visited: readonly boolean[], active: number | null): void
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
    ...{ scene: imageOf(root), covers, stations },
    cover(visited, worth) {
      for (const road of roads) fade(road, worth.get(road.id.slice('cover-'.length)) ?? 0, isCity)
      fog.forEach((patch, station) => set(patch, 'visibility', visited[station] ? 'hidden' : 'visible'))
    },
    dress: (visited, active) =>
      nodes.forEach((node, station) => node.dress(visited[station] ?? false, station === active)),
  }
}

const layersOf = (root: Element, ids: readonly string[]) =>
  ids.flatMap((id) => root.querySelector(`#${id}`) ?? [])

/** A thousand houses and trees are one thing for the browser then. */
function imageOf(root: Element): string {
  const viewBox = root.getAttribute('viewBox') ?? ''
  const [, , width = '1600', height = '1000'] = viewBox.split(' ')
  const image = make('svg', { viewBox, width, height })
  image.append(...layersOf(root, ['scenery', 'roads']))
  return `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(image))}`
}
