import { mix } from '#drawing/colours.ts'
import { clamp } from '#drawing/points.ts'

const POSITIVE = ['#FFF6D8', '#F5C64A', '#6DBE76'] as const
const NEGATIVE = ['#FFF6D8', '#C3D0D8', '#8DA1B0'] as const

/**
 * Colour of a value 0..100, as a Q-table has it; the higher the darker, so that it can be read in grey. Below 0 blue-grey; there
 * a pattern lies over it, see `isStriped`. @returns `#RRGGBB`
 */
export function heatOf(value: number): string {
  const scale = value < 0 ? NEGATIVE : POSITIVE
  const share = clamp(Math.abs(value) / 100, 0, 1) * 2
  return share <= 1 ? mix(scale[0], scale[1], share) : mix(scale[1], scale[2], share - 1)
}

/** Does this pixel of a negative value belong to a stripe? */
export const isStriped = (x: number, y: number): boolean => (x + y) % 6 < 2
