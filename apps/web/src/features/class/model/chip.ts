import type { Whereabouts } from '#storage/outbox.ts'
import type { Pause } from './sending.ts'

/** Where the open project is, as one word of a chip. */
export type ChipState = 'class' | 'onItsWay' | 'conflict' | 'refused' | Pause

/** @returns null where the device's own state comes first: it could not save, or another tab holds the project */
export function stateOf(
  local: 'saving' | 'saved' | 'failed' | 'elsewhere' | 'gone',
  place: Whereabouts | undefined,
  pause: Pause | null,
): ChipState | null {
  if (local !== 'saving' && local !== 'saved') return null
  if (place?.kind === 'conflict' || place?.kind === 'refused') return place.kind
  if (pause !== null) return pause
  // A project that nobody has changed yet is nowhere, and nothing of it can be lost.
  return local === 'saving' || place?.kind === 'waiting' ? 'onItsWay' : 'class'
}
