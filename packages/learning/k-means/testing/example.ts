import type { Example } from '../../testing/contract.ts'
import { pointsOf } from '../points.ts'

const rows = Array.from({ length: 30 }, (_, at) => [(at * 7) % 11, (at * 5) % 13, (at * 3) % 17])

export const example: Example = {
  parameters: { groups: 4, distance: 'manhattan', init: '++' },
  data: pointsOf(rows),
  steps: 200,
}
