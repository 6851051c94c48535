import { cos, sin } from '@botgarten/numbers'
import type { Lack } from '../types.ts'
import { heldFor, nameOf, numberOf, type Kind } from './kind.ts'
import { awayFrom, robotIn, speedIn, type Moment } from './moment.ts'

/** Slower than this is standing, in percent: what a program leaves behind when it has stopped the motors. */
const STANDING = 3

/** Cosine of the angle up to which a point is called ahead of the robot. */
const AHEAD = 0.5

/**
 * The middle of the robot's axle stands within `cm` of the point `x`, `y` for `seconds`; it stays passed. Counts only
 * after the check `after` has passed ('' counts from the start).
 */
export const arrives: Kind<{ held: number; done: boolean }> = {
  needs: ['x', 'y', 'cm', 'after'],
  lacks: ['before', 'beyond', 'beside', 'moving'],
  begin: () => ({ held: 0, done: false }),
  observe(check, moment, memory) {
    const after = nameOf(check, 'after')
    const counts = after === '' || moment.passed(after)
    const away = awayFrom(moment, numberOf(check, 'x'), numberOf(check, 'y'))
    const stands = counts && away <= numberOf(check, 'cm') && speedIn(moment) < STANDING
    memory.done = heldFor(check, memory, stands) || memory.done
    return memory.done
  },
  missing(check, _, moment): Lack {
    const to = { x: numberOf(check, 'x'), y: numberOf(check, 'y') }
    const away = awayFrom(moment, to.x, to.y)
    if (away <= numberOf(check, 'cm')) return { what: 'moving', facts: {} }
    const { x, y } = robotIn(moment)
    return { what: sideOf(moment, to, away), facts: { away }, gap: { from: { x, y }, to } }
  },
}

/** Where the robot stopped, seen the way it looks. */
function sideOf(moment: Moment, to: { readonly x: number; readonly y: number }, away: number): string {
  const { x, y, heading } = robotIn(moment)
  const ahead = ((to.x - x) * cos(heading) + (to.y - y) * sin(heading)) / away
  if (ahead > AHEAD) return 'before'
  return ahead < -AHEAD ? 'beyond' : 'beside'
}
