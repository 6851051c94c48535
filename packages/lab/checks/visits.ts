import type { Check } from '../types.ts'
import { nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom, robotIn } from './moment.ts'

/**
 * The middle of the robot's axle has come within `cm` of every point of `points` ("x y, x y, …"), in any order; it
 * stays passed.
 */
export const visits: Kind<{ seen: number[] }> = {
  needs: ['points', 'cm'],
  lacks: ['some'],
  begin: () => ({ seen: [] }),
  observe(check, moment, memory) {
    const points = pointsOf(check)
    points.forEach(([x, y], index) => {
      const near = awayFrom(moment, x, y) <= numberOf(check, 'cm')
      if (near && !memory.seen.includes(index)) memory.seen.push(index)
    })
    return memory.seen.length === points.length
  },
  missing(check, { seen }, moment) {
    const points = pointsOf(check)
    const open = points.filter((_, index) => !seen.includes(index))
    const [to, away] = open
      .map((point): [typeof point, number] => [point, awayFrom(moment, ...point)])
      .reduce((best, one) => (one[1] < best[1] ? one : best))
    const { x, y } = robotIn(moment)
    const gap = { from: { x, y }, to: { x: to[0], y: to[1] } }
    return { what: 'some', facts: { seen: seen.length, all: points.length, away }, gap }
  },
}

const pointsOf = (check: Check): readonly (readonly [x: number, y: number])[] =>
  nameOf(check, 'points')
    .split(',')
    .map((point) => point.trim().split(' ').map(Number))
    .map(([x, y]) => [x!, y!])
