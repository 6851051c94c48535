import { starter } from '../train/settings.ts'
import type { Brain, PracticeNote } from '../types.ts'

/** How a network practises next: what was chosen, else as it practised last, else the starter's. */
export type PracticeChoice = Pick<PracticeNote, 'seed' | 'settings'>

export const starterChoice: PracticeChoice = {
  seed: 1,
  settings: { ...starter, keepBack: 0, from: 'knobs', mirror: true },
}

export function practiceChoice({ practice }: Brain): PracticeChoice {
  const { seed, settings } = practice?.next ?? practice ?? starterChoice
  return { seed, settings }
}

/** The note with another choice; how it practised before stays. */
export const withChoice = (note: PracticeNote | undefined, next: PracticeChoice): PracticeNote =>
  note && note.round > 0 ? { ...note, next } : { ...next, start: {}, round: 0, curve: [], marks: [] }
