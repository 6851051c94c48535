import { StudyHands } from './child-study.ts'
import type { Screen } from './screens.ts'

export const studyScreens: readonly Screen[] = [
  { name: 'study', show: (child) => new StudyHands(child).comes() },
  {
    name: 'study-make',
    async show(child) {
      await new StudyHands(child).comes()
      await child.presses('study.make')
    },
  },
  {
    name: 'study-set-up',
    async show(child) {
      const hands = new StudyHands(child)
      await hands.comes()
      await hands.opens()
    },
  },
  { name: 'study-ask', show: (child) => new StudyHands(child).handsOut() },
  {
    name: 'study-parts',
    async show(child) {
      const hands = new StudyHands(child)
      await hands.handsOut()
      await hands.begins(1, 2)
    },
  },
  {
    name: 'study-lab',
    async show(child) {
      const hands = new StudyHands(child)
      await hands.handsOut()
      await hands.begins(1, 2)
      await hands.opensCard('friendship')
    },
  },
]
