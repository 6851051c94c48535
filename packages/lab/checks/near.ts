import { nameOf, numberOf, type Kind } from './kind.ts'
import { gapIn } from './moment.ts'

/** The robot's front has come within `cm` of the obstacle; it stays passed. */
export const near: Kind<{ came: boolean }> = {
  needs: ['obstacle', 'cm'],
  begin: () => ({ came: false }),
  observe(check, moment, memory) {
    const gap = gapIn(moment, nameOf(check, 'obstacle'))
    memory.came ||= gap !== null && gap <= numberOf(check, 'cm')
    return memory.came
  },
}
