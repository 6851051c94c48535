import { m } from '#words/message.ts'
import type { Chosen } from '../model/choices.svelte.ts'
import type { BlockEdits } from '../model/block-edits.ts'

export interface MapAction {
  readonly label: string
  act(): void
}

/** What can be made of a station; of a road that is closed in one direction, in both or in none. */
export function actionsOf(chosen: Chosen, edits: BlockEdits): MapAction[] {
  if (chosen.kind === 'ends') return []
  return chosen.kind === 'station' ? ofStation(chosen.station, edits) : ofRoad(chosen.a, chosen.b, edits)
}

const ofStation = (station: number, edits: BlockEdits): MapAction[] => [
  { label: m['q.startHere'](), act: () => edits.setStation('START', station) },
  { label: m['q.goalHere'](), act: () => edits.setStation('FINISH', station) },
]

function ofRoad(a: number, b: number, edits: BlockEdits): MapAction[] {
  const now = { there: edits.isClosed(a, b), back: edits.isClosed(b, a) }
  return [
    { label: m['q.openRoad'](), there: false, back: false },
    { label: m['q.closeRoad'](), there: true, back: true },
    { label: m['q.closeOne']({ from: a, to: b }), there: true, back: false },
    { label: m['q.closeOne']({ from: b, to: a }), there: false, back: true },
  ]
    .filter(({ there, back }) => there !== now.there || back !== now.back)
    .map(({ label, there, back }) => ({ label, act: () => edits.setRoad(a, b, there, back) }))
}
