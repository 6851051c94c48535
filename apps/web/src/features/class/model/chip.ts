import type { SaveStatus } from '#storage/autosave.ts'
import type { Whereabouts } from '#storage/outbox.ts'
import type { Pause } from './sending.ts'

/** Where the open project is, as one word of a chip. */
export type ChipState = 'class' | 'onItsWay' | 'conflict' | 'refused' | Pause

/** The open project on this device. */
export type Local = Pick<SaveStatus, 'state' | 'revision'>

/** @returns null where the device's own state comes first: it could not save, or another tab holds the project */
export function stateOf(
  { state: local, revision }: Local,
  place: Whereabouts | undefined,
  pause: Pause | null,
): ChipState | null {
  if (local !== 'saving' && local !== 'saved') return null
  if (place?.kind === 'conflict' || place?.kind === 'refused') return place.kind
  if (pause !== null) return pause
  // A project without a change is nowhere yet, and nothing of it can be lost.
  const inClass = place?.kind === 'class' ? place.revision : 0
  return local === 'saving' || place?.kind === 'waiting' || inClass < revision ? 'onItsWay' : 'class'
}
