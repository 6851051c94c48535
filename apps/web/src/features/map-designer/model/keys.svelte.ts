import { moveStation, removeRoad, removeStation } from '@botgarten/maps/own'
import type { Designer } from './designer.svelte.ts'
import { join, tap, type Target } from './hands.ts'

type OnMap = Extract<Target, { index: number }>

/** Units of the paper. */
const steps: { readonly [key: string]: readonly [x: number, y: number] } = {
  ...{ ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10] },
}

/** What keys do on the paper: they do the same as a hand. */
export class Keys {
  readonly #designer: Designer
  #first = $state<number | null>(null)

  constructor(designer: Designer) {
    this.#designer = designer
  }

  /** The station that a road begins at. */
  get first() {
    return this.#first
  }

  press = (event: KeyboardEvent, target: OnMap): void => {
    const step = steps[event.key]
    if (step && target.kind === 'station') this.#move(target.index, step, event.shiftKey ? 4 : 1)
    else if (event.key === 'Delete' || event.key === 'Backspace') this.#remove(target)
    else if (event.key === 'Enter' || event.key === ' ') this.#tap(target)
    else return
    event.preventDefault()
  }

  #move(station: number, [dx, dy]: readonly [x: number, y: number], far: number): void {
    const { map } = this.#designer
    const { x, y } = map.stations[station]!
    this.#designer.change(moveStation(map, station, { x: x + far * dx, y: y + far * dy }))
  }

  #remove({ kind, index }: OnMap): void {
    const { map } = this.#designer
    this.#designer.change(kind === 'station' ? removeStation(map, index) : removeRoad(map, index))
  }

  #tap(target: OnMap): void {
    if (target.kind === 'station' && this.#designer.tool === 'road') {
      const first = this.#first
      this.#first = first === null || first === target.index ? target.index : null
      if (first !== null && first !== target.index) return join(this.#designer, first, target.index)
    }
    tap(this.#designer, target, { x: 0, y: 0 })
  }
}
