import { TICKS_PER_SECOND } from '@botgarten/simulation'
import { numberOf, tooShort, type Kind } from './kind.ts'
import { robotIn } from './moment.ts'

interface Memory {
  ticks: number
  /** Way of the middle of the axle, in cm. */
  way: number
  bumps: number
  touches: boolean
  x: number | null
  y: number
  done: boolean
}

/** For `seconds` the robot has bumped into things at most `bumps` times and gone at least `cm` a minute; it stays passed. Learning by trying does not count: it begins after that. */
export const cruises: Kind<Memory> = {
  needs: ['cm', 'bumps'],
  lacks: ['bumped', 'slow', 'short'],
  begin: () => ({ ticks: 0, way: 0, bumps: 0, touches: false, x: null, y: 0, done: false }),
  observe(check, moment, memory) {
    if (memory.done) return true
    if (moment.trying) {
      Object.assign(memory, cruises.begin())
      return false
    }
    const { x, y, touching } = robotIn(moment)
    const [dx, dy] = [x - (memory.x ?? x), y - (memory.x === null ? y : memory.y)]
    const touches = touching.length > 0
    if (touches && !memory.touches) memory.bumps++
    memory.way += Math.sqrt(dx * dx + dy * dy)
    Object.assign(memory, { touches, x, y, ticks: memory.ticks + 1 })
    const isOver = memory.ticks >= check.seconds * TICKS_PER_SECOND
    memory.done =
      isOver && memory.bumps <= numberOf(check, 'bumps') && aMinute(memory) >= numberOf(check, 'cm')
    return memory.done
  },
  missing(check, memory) {
    const { bumps, ticks } = memory
    if (bumps > numberOf(check, 'bumps')) return { what: 'bumped', facts: { bumps }, broken: true }
    if (ticks < check.seconds * TICKS_PER_SECOND) return tooShort(check, ticks)
    return { what: 'slow', facts: { least: numberOf(check, 'cm'), most: Math.round(aMinute(memory)) } }
  },
}

/** cm a minute so far. */
const aMinute = ({ way, ticks }: Memory) => (ticks === 0 ? 0 : (way * 60 * TICKS_PER_SECOND) / ticks)
