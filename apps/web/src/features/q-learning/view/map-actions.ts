import { m } from '#words/message.ts'
import type { Chosen } from '../model/choices.svelte.ts'
import type { Hands } from '../model/hands.ts'

export interface MapAction {
  readonly label: string
  act(): void
}

/** What can be made of a station; of a road that is closed in one direction, in both or in none. */
export function actionsOf(chosen: Chosen, hands: Hands): MapAction[] {
  if (chosen.kind === 'ends') return []
  return chosen.kind === 'station' ? ofStation(chosen.station, hands) : ofRoad(chosen.a, chosen.b, hands)
}

const ofStation = (station: number, hands: Hands): MapAction[] => [
  { label: m['q.startHere'](), act: () => hands.setStation('START', station) },
  { label: m['q.goalHere'](), act: () => hands.setStation('FINISH', station) },
]

function ofRoad(a: number, b: number, hands: Hands): MapAction[] {
  const now = { there: hands.isClosed(a, b), back: hands.isClosed(b, a) }
  return [
    { label: m['q.openRoad'](), there: false, back: false },
    { label: m['q.closeRoad'](), there: true, back: true },
    { label: m['q.closeOne']({ from: a, to: b }), there: true, back: false },
    { label: m['q.closeOne']({ from: b, to: a }), there: false, back: true },
  ]
    .filter(({ there, back }) => there !== now.there || back !== now.back)
    .map(({ label, there, back }) => ({ label, act: () => hands.setRoad(a, b, there, back) }))
}
