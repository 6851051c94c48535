import { nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom } from './moment.ts'

/**
 * The middle of the robot's axle has come within `cm` of every point of `points` ("x y, x y, …"), in any order; it
 * stays passed.
 */
export const visits: Kind<{ seen: number[] }> = {
  needs: ['points', 'cm'],
  begin: () => ({ seen: [] }),
  observe(check, moment, memory) {
    const points = nameOf(check, 'points').split(',')
    points.forEach((point, index) => {
      const [x = NaN, y = NaN] = point.trim().split(' ').map(Number)
      const near = awayFrom(moment, x, y) <= numberOf(check, 'cm')
      if (near && !memory.seen.includes(index)) memory.seen.push(index)
    })
    return memory.seen.length === points.length
  },
}
