import type { IconName } from '#parts/icons.ts'
import { m } from '#words/message.ts'
import type { View } from '../ways.ts'

interface Tab {
  readonly id: View
  readonly icon: IconName
  readonly label: () => string
}

export const tabs: readonly Tab[] = [
  { id: 'live', icon: 'people', label: m['teacher.live'] },
  { id: 'cards', icon: 'card', label: m['teacher.cards'] },
  { id: 'gallery', icon: 'share', label: m['teacher.gallery'] },
  { id: 'questionnaires', icon: 'bars', label: m['teacher.questionnaires'] },
  { id: 'class', icon: 'person', label: m['teacher.settings'] },
  { id: 'data', icon: 'shield', label: m['teacher.data'] },
]
