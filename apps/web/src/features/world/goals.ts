import type { Check } from '@botgarten/lab'
import type { Sight } from '#drawing/camera.ts'

/** Places on the floor where a card wants the robot to arrive, in cm: they matter as things do. */
export const goalsOf = (checks: readonly Check[]): readonly Sight[] =>
  checks
    .filter(({ kind, numbers }) => kind === 'arrives' && numbers['after'] === '')
    .map(({ numbers }) => ({
      x: Number(numbers['x']),
      y: Number(numbers['y']),
      radius: Number(numbers['cm']),
    }))

/** Does a card ask for something on colours? They may be anywhere on the floor, so all of it matters. */
export const asksForColours = (checks: readonly Check[]): boolean =>
  checks.some(({ kind, numbers }) => kind !== 'neverSees' && 'colour' in numbers)
