import type { Ports } from '../ports.ts'
import { classOfPupil } from '../teaching/classes-store.ts'
import { cardsIn } from '../teaching/shown.ts'
import { pupilOf } from './pupils-store.ts'
import type { Pupil } from './sessions-store.ts'

/** What a pupil's page knows of itself and of the class. */
export async function meOf({ database: { db } }: Ports, { id, class: classId, nickname, fresh }: Pupil) {
  const row = await classOfPupil(db, classId)
  const pupil = await pupilOf(db, classId, id)
  const { name = '', language = 'en', grade = 0, openedAt = null, cards = null, level = null } = row ?? {}
  const { gallery = 0, asking = 0, together = 0 } = row ?? {}
  const of = {
    ...{ id: classId, name, language, grade, open: openedAt !== null, cards: cardsIn(cards), level },
    ...{ gallery: gallery === 1, asking: asking === 1, together: together === 1 },
  }
  return { id, nickname, fresh, hand: (pupil?.handAt ?? null) !== null, class: of }
}
