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
