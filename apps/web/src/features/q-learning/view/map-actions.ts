import type { MapFile } from '@botgarten/maps'
import { m } from '#words/message.ts'
import type { Chosen } from '../model/choices.svelte.ts'
import type { BlockEdits } from '../model/block-edits.ts'

export interface MapAction {
  readonly label: string
  act(): void
}

/** What can be made of a station; of a road that is closed in one direction, in both or in none. */
export function actionsOf(chosen: Chosen, edits: BlockEdits, map?: MapFile): MapAction[] {
  if (chosen.kind === 'ends') return []
  if (chosen.kind === 'station' && map?.grid) return ofRoom(chosen.station, edits, map)
  return chosen.kind === 'station' ? ofStation(chosen.station, edits) : ofRoad(chosen.a, chosen.b, edits)
}

/** The goals of rooms are where they are; nobody begins in a wall or behind the end. */
const ofRoom = (room: number, edits: BlockEdits, { map }: MapFile): MapAction[] =>
  map.actions[room]!.length > 0
    ? [{ label: m['q.startHere'](), act: () => edits.setStation('START', room) }]
    : []

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
