import { make, set } from './svg.ts'

const colours = { visited: '#1F7A45', unvisited: '#C23A30', active: '#1F67B3' }

/** What of a station changes. */
export interface StationLook {
  dress(visited: boolean, active: boolean): void
}

/**
 * Prepares the drawing of a station at a place. What is moved by a transformation is a part of its own for the browser,
 * in every frame: its circles go to their place instead.
 */
export function prepareStation(
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
  const tick = tickAt(x + radius * 0.78, y - radius * 0.78, radius / 40)
  node.append(tick)
  return {
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

function tickAt(x: number, y: number, size: number): SVGGElement {
  const tick = make('g')
  const round = { 'stroke-linecap': 'round', 'stroke-linejoin': 'round', fill: 'none' }
  tick.append(
    make('circle', {
      ...{ cx: x, cy: y, r: 14 * size },
      ...{ fill: '#fff', stroke: '#4A3428', 'stroke-width': 3 * size },
    }),
    make('path', {
      ...round,
      ...{ d: `M${x - 6 * size} ${y}l${4.5 * size} ${5 * size} ${8 * size} ${-9 * size}` },
      ...{ stroke: '#1F7A45', 'stroke-width': 4 * size },
    }),
  )
  return tick
}
