import type { Door } from './walk.svelte.ts'

/** Position of a door, 0..1 of the room. Only in a grid is it the side on which the door is on the map. */
export interface Place {
  readonly x: number
  readonly y: number
}

const sides: { readonly [side: string]: Place } = {
  ...{ left: { x: 0.15, y: 0.5 }, right: { x: 0.85, y: 0.5 } },
  ...{ up: { x: 0.5, y: 0.12 }, down: { x: 0.5, y: 0.88 } },
}

/** Places the doors of a station in a ring in the order of their actions, the first on the upper left. */
export function placesOf(doors: readonly Door[]): readonly Place[] {
  return doors.map(({ side }, index) => {
    if (side && sides[side]) return sides[side]
    const turn = (2 * Math.PI * (index + 0.5)) / doors.length - Math.PI
    return { x: 0.5 + 0.33 * Math.sin(turn), y: 0.5 - 0.38 * Math.cos(turn) }
  })
}

type Side = 'left' | 'right' | 'up' | 'down'

/** Is it a side to which a door of a grid's room leads? */
export const isSide = (side: string | null): side is Side => side !== null && Object.hasOwn(arrows, side)

export const arrows: { readonly [side: string]: string } = { left: '←', right: '→', up: '↑', down: '↓' }

/** The values without repeats, in the order of their first occurrence. */
export const distinct = (values: readonly number[]): readonly number[] => [...new Set(values)]
