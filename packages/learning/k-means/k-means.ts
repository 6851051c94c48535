import type { Learner } from '../learner.ts'
import { refuseOutside, type ObjectSchema } from '../parameters.ts'
import { beginAt, restore, save, step, type KSorting } from './sorting.ts'
import { plusPlusStart, randomStart } from './starts.ts'
import type { Distance, KState, KTrace, Points } from './types.ts'

interface KParameters {
  readonly groups: number
  readonly distance: Distance
  readonly init: 'random' | '++'
}

const parameters: ObjectSchema = {
  type: 'object',
  properties: {
    groups: { type: 'integer', minimum: 1 },
    distance: { enum: ['euclidean', 'manhattan', 'cosine'] },
    init: { enum: ['random', '++'] },
  },
  required: ['groups', 'distance', 'init'],
  additionalProperties: false,
}

/** A step is one operation: a point finds its centre, or a centre moves. A whole run without a trace: `cluster`. */
export const kMeans: Learner<KParameters, Points, KSorting, KState, KTrace> = {
  name: 'kmeans',
  parameters,
  begin(given, points, stream) {
    refuseOutside(parameters, given)
    const { groups, distance, init } = given
    const centres =
      init === '++' ? plusPlusStart(points, groups, distance, stream) : randomStart(points, groups, stream)
    return beginAt(points, centres, distance)
  },
  step,
  save,
  restore,
}
