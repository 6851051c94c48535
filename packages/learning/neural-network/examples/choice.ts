import { starter } from '../train/settings.ts'
import type { Settings } from '../train/types.ts'
import type { Brain, PracticeNote } from '../types.ts'
import type { Exercise } from './prepare.ts'

/** How a network practises next: what was chosen, else as it practised last, else the starter's. */
export type PracticeChoice = Pick<PracticeNote, 'seed' | 'settings'>

export const starterChoice: PracticeChoice = {
  seed: 1,
  settings: { ...starter, keepBack: 0, from: 'knobs', mirror: true },
}

export function practiceChoice({ practice }: Pick<Brain, 'practice'>): PracticeChoice {
  const { seed, settings } = practice?.next ?? practice ?? starterChoice
  return { seed, settings }
}

/** The note with another choice; how it practised before stays. */
export const withChoice = (note: PracticeNote | undefined, next: PracticeChoice): PracticeNote =>
  note && note.round > 0 ? { ...note, next } : { ...next, start: {}, round: 0, curve: [], marks: [] }

/** What practice itself takes of a choice; the rest decides how it begins. */
export function stepSettings({ settings }: PracticeChoice): Settings {
  const { keepBack: _held, from: _begins, mirror: _mirrored, ...rest } = settings
  return rest
}

/** What practises by a choice. `mirror`: which neuron stands for which; null: the network has no left and right. */
export function exerciseBy(
  { seed, settings }: PracticeChoice,
  shown: Pick<Exercise, 'id' | 'layers' | 'weights' | 'examples'>,
  mirror: Exercise['mirror'],
): Exercise {
  const { keepBack, from, mirror: mirrors } = settings
  return { ...shown, seed, keepBack, from, mirror: mirrors ? mirror : null }
}
