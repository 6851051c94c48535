import { nameOf, numberOf, type Kind } from './kind.ts'
import { gapIn } from './moment.ts'

/** The robot's front has come within `cm` of the obstacle; it stays passed. */
export const near: Kind<{ came: boolean; nearest: number | null }> = {
  needs: ['obstacle', 'cm'],
  lacks: ['far'],
  begin: () => ({ came: false, nearest: null }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    if (gap !== null) memory.nearest = Math.min(memory.nearest ?? gap, gap)
    memory.came ||= gap !== null && gap <= numberOf(check, 'cm')
    return memory.came
  },
  missing(check, { nearest }, moment) {
    const thing = nameOf(check, 'obstacle')
    return { what: 'far', facts: { thing, away: nearest ?? gapIn(moment, thing) ?? 0 } }
  },
}
