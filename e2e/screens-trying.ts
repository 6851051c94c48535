import { TryHands } from './child-trying.ts'
import type { Child } from './child.ts'
import type { Screen } from './screens.ts'

async function tries(child: Child, phone: boolean, seconds: number) {
  const bo = new TryHands(child)
  await child.opensLab('try-dodge')
  if (phone) return bo
  await bo.opensSolution()
  await child.pressesStart()
  await bo.time.opens()
  await bo.time.chooses('16')
  await bo.time.runsUntil(seconds)
  return bo
}

/** What Bo learns by trying with its own sensors. */
export const tryingScreens: readonly Screen[] = [
  { name: 'try-empty', show: (child) => child.opensLab('try-dodge') },
  {
    name: 'try-senses',
    neverPhone: true,
    show: async (child, phone) => void (await tries(child, phone, 60)),
  },
  {
    name: 'try-edges',
    neverPhone: true,
    async show(child, phone) {
      await tries(child, phone, 5)
      await child.presses('senses.edges')
    },
  },
]
